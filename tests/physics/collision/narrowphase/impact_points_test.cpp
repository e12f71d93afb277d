// SPDX-License-Identifier: MIT
//
// Where two shapes meet at the moment of an impact.
#include "physics/src/collision/narrowphase/impact_points.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A shape that falls by so much in a step.
SweptShape falling(const Geometry& geometry, Vec3 center, double way, Quat rotation = {}) {
    return {.geometry = &geometry,
            .radius = 2,
            .sweep = {.center = center, .rotation = rotation, .translation = {0, -way, 0}}};
}

// A box of 1 m, 2.5 m above the floor, falls by 4 m: it meets the floor half way, with four
// corners.
TEST(ImpactPoints, box_hits_the_floor_with_its_corners) {
    const Geometry box = Box{}, floor = Plane{}, table = Box{{5, 1, 5}};
    const SweptShape a = falling(box, {0, 2.5, 0}, 4), b = falling(floor, {}, 0);
    const auto on_plane = points_touching(a, b, 0.5, 5e-4);
    const auto on_table = points_touching(a, falling(table, {0, -1, 0}, 0), 0.5, 5e-4);
    for (const auto& points : {on_plane, on_table}) {
        ASSERT_EQ(points.size(), 4u);
        for (const ImpactPoint& point : points) {
            EXPECT_TRUE(near(point.normal, {0, -1, 0}, 1e-9)) << "from a, which falls";
            EXPECT_NEAR(point.position.y, 0, 1e-3);
            EXPECT_NEAR(absolute(point.position.x), 0.5, 1e-9);
        }
    }
    EXPECT_TRUE(points_touching(a, b, 0.25, 5e-4).empty()) << "a metre above it";
}

// Two balls of a dumbbell that lies flat touch at once, each in its own point.
TEST(ImpactPoints, each_child_of_a_compound_has_its_own_points) {
    const Geometry pair = Compound{must(build_compound(
        {{Sphere{0.5}, {.position = {1, 0, 0}}}, {Sphere{0.5}, {.position = {-1, 0, 0}}}}))};
    const Geometry table = Box{{5, 1, 5}};
    const auto points =
        points_touching(falling(pair, {0, 2.5, 0}, 4), falling(table, {0, -1, 0}, 0), 0.5, 5e-4);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_NEAR(absolute(points[0].position.x - points[1].position.x), 2, 1e-6);
}

// What met with one point of a part meets as a whole along the same normal.
TEST(ImpactPoints, uses_the_full_shapes_along_a_given_normal) {
    const Geometry box = Box{}, floor = Plane{}, table = Box{{5, 1, 5}};
    const SweptShape a = falling(box, {0, 2.5, 0}, 4);
    const Impact impact{.fraction = 0.5, .normal = {0, -1, 0}, .point = {0, 0, 0}};
    const auto on_plane = points_along(a, falling(floor, {}, 0), impact);
    ASSERT_EQ(on_plane.size(), 4u);
    for (const ImpactPoint& point : on_plane) EXPECT_NEAR(absolute(point.position.z), 0.5, 1e-9);
    const auto on_table = points_along(a, falling(table, {0, -1, 0}, 0), impact);
    ASSERT_EQ(on_table.size(), 4u);
    for (const ImpactPoint& point : on_table) {
        EXPECT_NEAR(absolute(point.position.x), 0.5, 1e-9);
        EXPECT_EQ(point.normal, impact.normal);
    }
}

}  // namespace
}  // namespace jostle::test
