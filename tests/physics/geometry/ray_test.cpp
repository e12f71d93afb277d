// SPDX-License-Identifier: MIT
//
// Rays against each kind where the answer is known. Against marching: world/query_test.cpp.
#include "physics/src/geometry/ray.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// 4 m towards +x that begin `x` m before the shape's origin, at this height.
std::optional<ShapeRayHit> from_left(const Geometry& geometry, double height, double x = -3) {
    return cast_ray(transformed_shape(geometry, {}), {x, height, 0}, {4, 0, 0});
}

void expect_hit(const std::optional<ShapeRayHit>& hit, double fraction, Vec3 normal) {
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, fraction, 1e-12);
    EXPECT_TRUE(near(hit->normal, normal, 1e-12));
}

TEST(Ray, hits_round_shapes_at_the_analytic_point) {
    // At a height of 0.6 a unit ball is 0.8 wide.
    expect_hit(from_left(Sphere{1}, 0.6), 2.2 / 4, {-0.8, 0.6, 0});
    expect_hit(from_left(Capsule{1, 2}, 2.6), 2.2 / 4, {-0.8, 0.6, 0});
    expect_hit(from_left(Capsule{1, 2}, 1.9), 2.0 / 4, {-1, 0, 0});
    EXPECT_FALSE(from_left(Sphere{1}, 1.001));
    EXPECT_FALSE(from_left(Sphere{1}, 0, 3));
    EXPECT_FALSE(from_left(Sphere{1}, 0, -5.001)) << "ends a millimetre before it";
}

TEST(Ray, hits_flat_and_slanted_sides) {
    expect_hit(from_left(Box{{1, 2, 3}}, 1.9), 2.0 / 4, {-1, 0, 0});
    expect_hit(from_left(Cylinder{1, 2}, 1.9), 2.0 / 4, {-1, 0, 0});
    // A cone of radius 2 and height 4: half way up its radius is 1, its side leans by atan(1/2).
    expect_hit(from_left(Cone{2, 2}, 0), 2.0 / 4, normalized(Vec3{-2, 1, 0}));
    const std::vector<Vec3> points{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                   {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const Geometry octahedron = Hull{must(build_hull(points))};
    const auto hit = cast_ray(transformed_shape(octahedron, {}), {-1, 0.2, 0.3}, {2, 0, 0});
    expect_hit(hit, 0.5 / 2, normalized(Vec3{-1, 1, 1}));
}

TEST(Ray, hits_flat_ends_from_above) {
    for (const Geometry& shape : {Geometry{Cylinder{1, 2}}, Geometry{Box{{1, 2, 1}}}})
        expect_hit(cast_ray(transformed_shape(shape, {}), {0.5, 6, 0.5}, {0, -8, 0}), 0.5,
                   {0, 1, 0});
    const Geometry cone = Cone{1, 2};
    expect_hit(cast_ray(transformed_shape(cone, {}), {0.5, -6, 0.5}, {0, 8, 0}), 0.5, {0, -1, 0});
}

TEST(Ray, from_inside_returns_fraction_zero_and_the_opposite_normal) {
    for (const Geometry& shape :
         {Geometry{Sphere{1}}, Geometry{Capsule{1, 1}}, Geometry{Box{{1, 1, 1}}},
          Geometry{Cylinder{1, 1}}, Geometry{Cone{1, 1}}, Geometry{Plane{}}}) {
        SCOPED_TRACE(kind_name(kind_of(shape)));
        expect_hit(cast_ray(transformed_shape(shape, {}), {0.1, -0.2, 0.1}, {0, 3, 4}), 0,
                   {0, -0.6, -0.8});
    }
}

TEST(Ray, hits_a_triangle_from_both_sides) {
    const Vec3 corner[3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const auto down = cast_at_triangle({0.25, 1, 0.25}, {0, -4, 0}, corner);
    const auto up = cast_at_triangle({0.25, -1, 0.25}, {0, 4, 0}, corner);
    expect_hit(down, 0.25, {0, 1, 0});
    expect_hit(up, 0.25, {0, -1, 0});
    EXPECT_FALSE(cast_at_triangle({0.6, 1, 0.6}, {0, -4, 0}, corner)) << "beyond its long side";
    EXPECT_FALSE(cast_at_triangle({0.25, 1, 0.25}, {1, 0, 0}, corner)) << "along it";
}

// From 1000 km away a ball of 1 m is met to a tenth of a millimetre: the root's discriminant is a
// difference of squares of kilometres.
TEST(Ray, long_ray_is_accurate_to_0_1_mm) {
    const Geometry ball = Sphere{1};
    const auto hit = cast_ray(transformed_shape(ball, {}), {-1e6, 0.6, 0}, {2e6, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction * 2e6 - 1e6, -0.8, 1e-4);
}

// Of a compound's two balls the nearer one, in the compound's own pose.
TEST(Ray, hits_the_nearest_child_of_a_compound) {
    const Geometry pair = Compound{must(build_compound(
        {{Sphere{0.5}, {.position = {0, 0, 2}}}, {Sphere{0.5}, {.position = {0, 0, -2}}}}))};
    // Turned so that its z axis points along x.
    const Transform pose{{10, 0, 0}, from_axis_angle({0, 1, 0}, pi / 2)};
    expect_hit(cast_ray(transformed_shape(pair, pose), {0, 0, 0}, {30, 0, 0}), 7.5 / 30,
               {-1, 0, 0});
}

}  // namespace
}  // namespace jostle::test
