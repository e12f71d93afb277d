// SPDX-License-Identifier: MIT
//
// The furthest point of each core along a direction.
#include "physics/src/geometry/support.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

Vec3 support_of(const Geometry& geometry, Vec3 direction) {
    return support(convex_of(transformed_shape(geometry, {}), {}), direction);
}

TEST(Support, matches_known_cores_along_axes) {
    EXPECT_EQ(support_of(Sphere{2}, {1, 2, 3}), Vec3{}) << "the radius is put on afterwards";
    EXPECT_EQ(support_of(Capsule{0.5, 3}, {9, -0.1, 0}), (Vec3{0, -3, 0}));
    EXPECT_EQ(support_of(Box{{1, 2, 3}}, {0.1, -5, 1}), (Vec3{1, -2, 3}));
    EXPECT_TRUE(near(support_of(Cylinder{5, 2}, {3, 1, -4}), {3, 2, -4}, 1e-12));
    EXPECT_EQ(support_of(Cylinder{5, 2}, {0, -1, 0}), (Vec3{0, -2, 0})) << "the middle of the disc";
}

// The side of a cone of radius 3 and height 4 has the slope 3/4: what looks up more steeply than
// its normal (4, 3) sees the tip, all else the rim.
TEST(Support, cone_support_is_its_tip_or_rim) {
    const Geometry cone = Cone{3, 2};
    EXPECT_EQ(support_of(cone, {3.99, 3, 0}), (Vec3{0, 2, 0}));
    EXPECT_TRUE(near(support_of(cone, {4.01, 3, 0}), {3, -2, 0}, 1e-12));
    EXPECT_TRUE(near(support_of(cone, {0, -1, -1e-3}), {0, -2, -3}, 1e-12));
}

// 0 and -0 are one direction: the sign of a zero must not decide which corner it is.
TEST(Support, ignores_the_sign_of_zero) {
    const Geometry box = Box{{1, 2, 3}}, rod = Capsule{0.1, 1};
    EXPECT_EQ(support_of(box, {-0.0, -0.0, -0.0}), support_of(box, {0, 0, 0}));
    EXPECT_EQ(support_of(rod, {1, -0.0, 0}), support_of(rod, {1, 0, 0}));
}

TEST(Support, hulls_and_triangles_match_brute_force) {
    Random random(21);
    for (int round = 0; round < 300; round++) {
        const Geometry geometry = random_geometry(ShapeKind::hull, random);
        const auto& vertices = std::get<Hull>(geometry).data->vertices;
        const Vec3 corner[3] = {vertices[0], vertices[1], vertices[2]};
        const Transform pose{random.vector(10), random.rotation()};
        const Convex hull = convex_of(transformed_shape(geometry, pose), {});
        const Convex triangle = triangle_convex(corner, pose.position, to_matrix(pose.rotation));
        const Vec3 d = random.direction();
        const auto furthest = [&](std::span<const Vec3> points) {
            double most = -1e300;
            for (const Vec3 p : points) most = maximum(most, dot(apply(pose, p), d));
            return most;
        };
        EXPECT_NEAR(dot(support(hull, d), d), furthest(vertices), 1e-12);
        EXPECT_NEAR(dot(support(triangle, d), d), furthest(corner), 1e-12);
    }
}

// Ten thousand kilometres from the origin doubles are 2 nm apart: differences are taken first.
TEST(Support, is_relative_to_the_given_origin) {
    const Vec3 far{1e7, -1e7, 1e7};
    const Geometry box = Box{{0.1, 0.2, 0.3}};
    const Convex convex = convex_of(transformed_shape(box, {far + Vec3{1, 0, 0}, {}}), far);
    EXPECT_TRUE(near(support(convex, {1, 1, 1}), {1.1, 0.2, 0.3}, 1e-15));
}

// From the middle the whole core lies within twice its size, and some of it on every side.
TEST(Support, middle_is_inside_and_size_is_an_upper_bound) {
    Random random(22);
    for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box,
                                 ShapeKind::cylinder, ShapeKind::cone, ShapeKind::hull})
        for (int round = 0; round < 50; round++) {
            const Geometry geometry = random_geometry(kind, random);
            const Convex shape =
                convex_of(transformed_shape(geometry, {random.vector(5), random.rotation()}), {});
            const Vec3 d = random.direction(), middle = middle_of(shape);
            const double reach = dot(support(shape, d) - middle, d) + shape.radius;
            EXPECT_GT(reach, 0) << kind_name(kind);
            EXPECT_LE(reach, 2 * size_of(shape)) << kind_name(kind);
        }
    const Geometry box = Box{{2, 3, 6}};
    EXPECT_EQ(size_of(convex_of(transformed_shape(box, {}), {})), 7);
}

}  // namespace
}  // namespace jostle::test
