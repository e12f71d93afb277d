// SPDX-License-Identifier: MIT
//
// Signed distances of simple shapes and the points where they are attained.
#include "physics/src/collision/narrowphase/shape_distance.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

SignedDistance between(const Geometry& a, Vec3 at_a, const Geometry& b, Vec3 at_b) {
    PairCache cache;
    return signed_distance(transformed_shape(a, {at_a, {}}), transformed_shape(b, {at_b, {}}),
                           cache);
}

TEST(ShapeDistance, is_between_surfaces_not_cores) {
    const SignedDistance d = between(Sphere{1}, {}, Capsule{0.5, 2}, {4, 1, 0});
    EXPECT_NEAR(d.distance, 2.5, 1e-9);
    EXPECT_TRUE(near(d.normal, {1, 0, 0}, 1e-9));
    EXPECT_TRUE(near(d.on_a, {1, 0, 0}, 1e-9));
    EXPECT_TRUE(near(d.on_b, {3.5, 0, 0}, 1e-9));
    EXPECT_NEAR(between(Sphere{1}, {}, Sphere{1}, {1.5, 0, 0}).distance, -0.5, 1e-9);
}

// A box whose lower side is half a metre below a plane, asked from both sides.
TEST(ShapeDistance, distance_to_a_plane_is_that_of_the_lowest_point) {
    const SignedDistance d = between(Plane{}, {0, 1, 0}, Box{{1, 2, 3}}, {9, 2.5, 9});
    EXPECT_NEAR(d.distance, -0.5, 1e-12);
    EXPECT_TRUE(near(d.normal, {0, 1, 0}, 1e-12));
    EXPECT_NEAR(d.on_a.y, 1, 1e-12);
    EXPECT_NEAR(d.on_b.y, 0.5, 1e-12);
    const SignedDistance turned = between(Box{{1, 2, 3}}, {9, 2.5, 9}, Plane{}, {0, 1, 0});
    EXPECT_NEAR(turned.distance, -0.5, 1e-12);
    EXPECT_TRUE(near(turned.normal, {0, -1, 0}, 1e-12));
    EXPECT_EQ(turned.on_a, d.on_b);
}

TEST(ShapeDistance, is_symmetric_and_equals_the_distance_of_its_points) {
    Random random(151);
    constexpr ShapeKind kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                                   ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};
    for (int round = 0; round < 1000; round++) {
        const Geometry a = random_geometry(kinds[random.below(6)], random);
        const Geometry b = random_geometry(kinds[random.below(6)], random);
        const TransformedShape pa = transformed_shape(a, {random.vector(100), random.rotation()});
        const TransformedShape pb =
            transformed_shape(b, {pa.position + random.vector(3), random.rotation()});
        PairCache forth, back;
        const SignedDistance ab = signed_distance(pa, pb, forth);
        const SignedDistance ba = signed_distance(pb, pa, back);
        ASSERT_NEAR(ab.distance, ba.distance, 2e-3) << round;
        EXPECT_NEAR(dot(ab.on_b - ab.on_a, ab.normal), ab.distance, 1e-5) << round;
    }
}

}  // namespace
}  // namespace jostle::test
