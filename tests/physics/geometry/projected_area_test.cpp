// SPDX-License-Identifier: MIT
//
// Shadows: closed forms, and against a count of rays that hit.
#include "physics/src/geometry/shape_measures.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"
#include "tests/support/random_shapes.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ProjectedArea, box_along_an_axis_shows_one_face) {
    const Box box{{1, 2, 3}};
    EXPECT_NEAR(projected_area(box, {1, 0, 0}), 24, 1e-12);
    EXPECT_NEAR(projected_area(box, {0, -1, 0}), 12, 1e-12);
    // A unit cube along its diagonal shows a hexagon of area root 3.
    EXPECT_NEAR(projected_area(Box{}, normalized(Vec3{1, 1, -1})), square_root(3), 1e-12);
}

TEST(ProjectedArea, round_shapes_match_the_closed_form) {
    EXPECT_NEAR(projected_area(Sphere{2}, normalized(Vec3{1, 2, 3})), 4 * pi, 1e-12);
    EXPECT_NEAR(projected_area(Capsule{1, 3}, {1, 0, 0}), pi + 12, 1e-12);
    EXPECT_NEAR(projected_area(Cylinder{1, 3}, {0, 1, 0}), pi, 1e-12);
    EXPECT_NEAR(projected_area(Cylinder{1, 3}, {0, 0, 1}), 12, 1e-12);
    EXPECT_NEAR(projected_area(Cone{1, 3}, {0, 0, 1}), 6, 1e-9) << "a triangle";
    EXPECT_NEAR(projected_area(Cone{1, 3}, {0, 1, 0}), pi, 1e-12) << "its base";
    EXPECT_EQ(projected_area(Plane{}, {0, 1, 0}), 0);
}

// A hull of the tip and 64 points of the base circle, whose area is sin(x)/x of the circle's, x = 2
// pi / 64.
TEST(ProjectedArea, cone_matches_a_hull_of_its_points) {
    std::vector<Vec3> points{{0, 1.5, 0}};
    for (int k = 0; k < 64; k++) {
        const SinCos turn = sin_cos(2 * pi * k / 64);
        points.push_back({0.8 * turn.cos, -1.5, 0.8 * turn.sin});
    }
    const Hull hull{must(build_hull(points))};
    for (const double y : {0.0, 0.1, 0.26, 0.3, 0.7, 0.95}) {
        const Vec3 d{square_root(1 - y * y), y, 0};
        EXPECT_NEAR(projected_area(Cone{0.8, 1.5}, d) / projected_area(hull, d), 1, 2e-3) << y;
    }
}

TEST(ProjectedArea, compound_is_the_sum_of_its_children) {
    const Quat turn = from_axis_angle({0, 0, 1}, pi / 2);
    const Compound compound{must(build_compound(
        {{Sphere{1}, {.position = {5, 0, 0}}}, {Cylinder{1, 3}, {{0, 0, 0}, turn}}}))};
    EXPECT_NEAR(projected_area(compound, {0, 1, 0}), pi + 12, 1e-12);
}

}  // namespace
}  // namespace jostle::test
