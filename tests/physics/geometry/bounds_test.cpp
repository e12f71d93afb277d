// SPDX-License-Identifier: MIT
//
// Boxes are as tight as the shapes' furthest points, in any pose.
#include "physics/src/geometry/shape_measures.h"

#include <gtest/gtest.h>

#include "physics/src/geometry/support.h"
#include "tests/support/near.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr ShapeKind convex_kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                                      ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};

// A disc's reach is sqrt(1 - c^2), which knows a cosine near one to the root of a rounding.
TEST(Bounds, are_tight_for_convex_shapes) {
    constexpr double rounding = 2e-8;  // m
    Random random(11);
    for (const ShapeKind kind : convex_kinds)
        for (int round = 0; round < 200; round++) {
            SCOPED_TRACE(testing::Message() << kind_name(kind) << " " << round);
            const Geometry geometry = random_geometry(kind, random);
            const TransformedShape shape =
                transformed_shape(geometry, {random.vector(20), random_rotation(random)});
            const Aabb box = bounds_of(shape);
            const Convex convex = convex_of(shape, {});
            for (int axis = 0; axis < 3; axis++) {
                Vec3 along;
                along[axis] = 1;
                ASSERT_NEAR(box.high[axis], support(convex, along)[axis] + convex.radius, rounding);
                ASSERT_NEAR(box.low[axis], support(convex, -along)[axis] - convex.radius, rounding);
            }
        }
}

// A cylinder of radius 1 and height 2 that leans by 45 degrees reaches sqrt 2 both ways.
TEST(Bounds, are_exact_for_a_tilted_cylinder) {
    const Geometry cylinder = Cylinder{1, 1};
    const Aabb box =
        bounds_of(transformed_shape(cylinder, {{5, 0, 0}, from_axis_angle({0, 0, 1}, pi / 4)}));
    const double reach = square_root(2);
    EXPECT_TRUE(near(box.low, {5 - reach, -reach, -1}, 1e-12));
    EXPECT_TRUE(near(box.high, {5 + reach, reach, 1}, 1e-12));
}

// What has many parts gets the box of its own box: all vertices are inside.
TEST(Bounds, contain_all_vertices_of_a_rotated_mesh) {
    Random random(12);
    const Vec3 corners[] = {{0, 1, 0}, {3, 1, 0}, {0, 0, 2}, {0, 0, -1}};
    const std::array<std::uint32_t, 3> triangles[] = {{0, 2, 1}, {0, 1, 3}};
    const Geometry mesh = Mesh{must(build_mesh(corners, triangles))};
    for (int round = 0; round < 50; round++) {
        const Transform pose{random.vector(5), random.rotation()};
        const Aabb box = grow(bounds_of(transformed_shape(mesh, pose)), 1e-12);
        for (const Vec3 corner : corners) {
            const Vec3 p = apply(pose, corner);
            EXPECT_TRUE(contains(box, {p, p})) << round;
        }
    }
    EXPECT_NEAR(radius_of(mesh), length(Vec3{3, 1, 2}), 1e-12) << "the corner of its box";
}

TEST(Bounds, radius_reaches_the_furthest_point) {
    EXPECT_EQ(radius_of(Sphere{2}), 2);
    EXPECT_EQ(radius_of(Capsule{0.5, 1}), 1.5);
    EXPECT_EQ(radius_of(Box{{2, 3, 6}}), 7);
    EXPECT_EQ(radius_of(Cylinder{3, 4}), 5);
    EXPECT_EQ(radius_of(Cone{3, 4}), 5) << "of the rim; the tip is nearer";
    const auto hull =
        must(build_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, -9}}));
    EXPECT_EQ(radius_of(Hull{hull}), 9);
}

}  // namespace
}  // namespace jostle::test
