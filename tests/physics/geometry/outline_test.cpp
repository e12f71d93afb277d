// SPDX-License-Identifier: MIT
//
// Outlines in the plane, and what a slice of 1 m weighs.
#include "physics/src/geometry/outline.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

Geometry hull_of(const std::vector<Vec3>& points) {
    return Hull{must(build_hull(points))};
}

// m^2; positive: counter-clockwise.
double area_of(const Outline& outline) {
    double twice = 0;
    for (int k = 0; k < outline.count; k++)
        twice += cross(outline.corner[k], outline.corner[(k + 1) % outline.count]).z;
    return twice / 2;
}

TEST(Outline, rotated_box_has_four_corners_and_the_projected_area) {
    const Geometry box = Box{{2, 1, 0.5}};
    const Outline outline = outline_of(
        transformed_shape(box, {{10, 5, 7}, from_axis_angle({0, 0, 1}, 0.5)}), {10, 5, 0});
    ASSERT_EQ(outline.count, 4);
    EXPECT_EQ(outline.radius, 0);
    EXPECT_NEAR(area_of(outline), 8, 1e-12);
    for (int k = 0; k < 4; k++) {
        EXPECT_EQ(outline.corner[k].z, 0);
        EXPECT_NEAR(length(outline.corner[k]), square_root(5), 1e-12);
    }
}

TEST(Outline, round_shapes_are_a_point_or_a_segment_with_a_radius) {
    const Geometry disc = Sphere{0.3}, stadium = Capsule{0.2, 0.7};
    const Outline point = outline_of(transformed_shape(disc, {{1, 2, 0}, {}}), {});
    EXPECT_EQ(point.count, 1);
    EXPECT_EQ(point.radius, 0.3);
    EXPECT_EQ(point.corner[0], (Vec3{1, 2, 0}));
    const Outline segment = outline_of(transformed_shape(stadium, {{1, 2, 0}, {}}), {1, 0, 0});
    ASSERT_EQ(segment.count, 2);
    EXPECT_EQ(segment.radius, 0.2);
    EXPECT_EQ(segment.corner[0], (Vec3{0, 1.3, 0}));
    EXPECT_EQ(segment.corner[1], (Vec3{0, 2.7, 0}));
}

// The shadow of an octahedron along z is the square of its four corners in the plane; both tips
// fall into its middle.
TEST(Outline, hull_outline_is_its_projection) {
    const Geometry octahedron =
        hull_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    const Outline outline = outline_of(transformed_shape(octahedron, {}), {});
    EXPECT_EQ(outline.count, 4);
    EXPECT_NEAR(area_of(outline), 2, 1e-12);
}

// Every vertex of a random hull is on the left of every side of its outline.
TEST(Outline, hull_outline_contains_all_vertices_and_is_counter_clockwise) {
    Random random(41);
    for (int round = 0; round < 200; round++) {
        std::vector<Vec3> points;
        for (int k = 0; k < 20; k++) points.push_back(random.vector(1));
        const Geometry hull = hull_of(points);
        const Outline outline = outline_of(transformed_shape(hull, {}), {});
        ASSERT_GE(outline.count, 3);
        for (int k = 0; k < outline.count; k++) {
            const Vec3 from = outline.corner[k], to = outline.corner[(k + 1) % outline.count];
            for (const Vec3 p : points)
                ASSERT_GE(cross(to - from, {p.x - from.x, p.y - from.y, 0}).z, -1e-12);
        }
    }
}

TEST(Outline, slice_masses_match_their_areas) {
    const MassProperties disc = planar_mass_of(Sphere{2}, 10);
    EXPECT_NEAR(disc.mass, 10 * pi * 4, 1e-9);
    EXPECT_NEAR(disc.inertia.z.z, disc.mass * 4 / 2, 1e-9);
    const MassProperties box = planar_mass_of(Box{{3, 1, 9}}, 10);
    EXPECT_NEAR(box.mass, 10 * 12, 1e-9);
    EXPECT_NEAR(box.inertia.z.z, box.mass * (9 + 1) / 3, 1e-9);
    // A right triangle, as a prism: its centre is a third of the way along both legs.
    const MassProperties prism = planar_mass_of(
        hull_of({{0, 0, 0}, {3, 0, 0}, {0, 6, 0}, {0, 0, 1}, {3, 0, 1}, {0, 6, 1}}), 10);
    EXPECT_NEAR(prism.mass, 10 * 9, 1e-9);
    EXPECT_TRUE(near(prism.center, {1, 2, 0}, 1e-9));
    EXPECT_NEAR(prism.inertia.z.z, prism.mass * (9 + 36) / 18, 1e-9);
    EXPECT_EQ(planar_mass_of(Plane{}, 10).mass, 0);
}

// Against a sum over cells of a millimetre.
TEST(Outline, slice_of_a_capsule_matches_a_sum_over_cells) {
    const Capsule capsule{0.2, 0.3};
    double mass = 0, second = 0;
    constexpr double cell = 1e-3;
    for (double x = cell / 2 - 0.2; x < 0.2; x += cell)
        for (double y = cell / 2 - 0.5; y < 0.5; y += cell) {
            const double over = maximum(absolute(y) - capsule.half_length, 0);
            if (x * x + over * over > capsule.radius * capsule.radius) continue;
            mass += cell * cell;
            second += cell * cell * (x * x + y * y);
        }
    const MassProperties slice = planar_mass_of(capsule, 1);
    EXPECT_NEAR(slice.mass, mass, 1e-3 * mass);
    EXPECT_NEAR(slice.inertia.z.z, second, 1e-3 * second);
}

}  // namespace
}  // namespace jostle::test
