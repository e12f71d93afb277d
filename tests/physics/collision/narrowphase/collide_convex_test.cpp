// SPDX-License-Identifier: MIT
//
// Two convex shapes that are known to be apart, and what a pair remembers. Against a search over
// all directions: collide_test.cpp.
#include "physics/src/collision/narrowphase/collide_convex.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

// Boxes and hulls anywhere about each other: what separate() says is enough to find the same
// manifold or distance.
TEST(CollideConvex, separated_shapes_match_the_full_search) {
    Random random(81);
    int apart = 0;
    for (int round = 0; round < 2000; round++) {
        const Geometry ga = random_geometry(ShapeKind::box, random);
        const Geometry gb =
            random_geometry(round % 2 == 0 ? ShapeKind::hull : ShapeKind::box, random);
        const Convex a = convex_of(transformed_shape(ga, {{}, random.rotation()}), {});
        const Convex b =
            convex_of(transformed_shape(gb, {random.vector(2), random.rotation()}), {});
        const Separation s = separate(a, b, 0, 1e300);
        if (s.distance <= 0) continue;
        apart++;
        const double margin = random.in(0, 0.5);
        PairCache cache;
        const Manifold whole = collide_convex(a, b, margin, cache);
        const auto known = collide_apart(a, b, s.normal, s.distance, margin);
        ASSERT_TRUE(known);
        ASSERT_EQ(known->count > 0, whole.count > 0) << round;
        if (whole.count == 0) {
            EXPECT_GT(known->distance, margin) << round << ": a lower bound is enough";
            continue;
        }
        EXPECT_NEAR(known->distance, whole.distance, 1e-6) << round;
        EXPECT_TRUE(near(known->normal, whole.normal, 1e-4)) << round;
    }
    EXPECT_GT(apart, 500);
}

// Hulls that move a little between two tests: the second one may use the axis of the first.
TEST(CollideConvex, cached_axis_gives_the_gap_of_the_full_search) {
    Random random(82);
    int near_pairs = 0, along_axis = 0;
    for (int round = 0; round < 4000; round++) {
        const Geometry ga = random_geometry(ShapeKind::hull, random),
                       gb = random_geometry(ShapeKind::hull, random);
        const Quat turn_a = random.rotation(), turn_b = random.rotation();
        const auto at = [&](Vec3 position, Quat rotation) {
            return convex_of(transformed_shape(gb, {position, rotation}), {});
        };
        const Convex a = convex_of(transformed_shape(ga, {{}, turn_a}), {});
        const Vec3 far = random.direction() * 5;
        PairCache cache;
        const Witness w = find_witness(a, at(far, turn_b), 1e300, cache);
        if (w.distance <= 0) continue;
        // From 2 mm in each other to 2 cm apart.
        const Vec3 place = far - w.normal * (w.distance - random.in(-0.002, 0.02));
        collide_convex(a, at(place, turn_b), 0.02, cache);
        const AxisCode axis = cache.axis;
        const Convex b = at(place + random.vector(0.002),
                            normalized(from_rotation_vector(random.vector(0.005)) * turn_b));
        const Manifold m = collide_convex(a, b, 0.02, cache);
        PairCache fresh;
        const Manifold whole = collide_convex(a, b, 0.02, fresh);
        near_pairs++;
        if (axis == cache.axis && axis != 0) along_axis++;
        if ((m.count == 0) != (whole.count == 0)) {
            EXPECT_NEAR(whole.distance, 0.02, 1e-6) << round;
            continue;
        }
        if (whole.count == 0) continue;
        // Apart, the gap is exact; overlapping, another axis may show less overlap.
        const double tolerance = whole.distance > 0 ? 5e-5 : 2e-3 * 2;
        EXPECT_NEAR(m.distance, whole.distance, tolerance) << round;
    }
    EXPECT_GT(near_pairs, 2000);
    EXPECT_GT(along_axis, near_pairs / 2);
}

TEST(CollideConvex, returns_nothing_if_the_shapes_touch) {
    const Geometry box = Box{};
    const Convex a = convex_of(transformed_shape(box, {}), {}),
                 b = convex_of(transformed_shape(box, {{0.9, 0, 0}, {}}), {});
    EXPECT_FALSE(collide_apart(a, b, {1, 0, 0}, 0.1, 0.02));
}

// A ball over the edge of a box is as far away as the edge is, less its radius.
TEST(CollideConvex, returns_a_lower_bound_beyond_the_margin) {
    const Geometry box = Box{}, ball = Sphere{0.5};
    const Convex a = convex_of(transformed_shape(box, {}), {});
    const Convex b = convex_of(transformed_shape(ball, {{3.5, 4.5, 0}, {}}), {});
    PairCache cache;
    const Witness exact = find_witness(a, b, 1e300, cache);
    EXPECT_NEAR(exact.distance, 5, 1e-9);
    EXPECT_TRUE(near(exact.normal, {0.6, 0.8, 0}, 1e-9));
    EXPECT_TRUE(near(exact.on_a, {0.5, 0.5, 0}, 1e-9));
    PairCache fresh;
    const Manifold m = collide_convex(a, b, 0.02, fresh);
    EXPECT_EQ(m.count, 0);
    EXPECT_GT(m.distance, 0.02);
    EXPECT_LE(m.distance, 4.5 + 1e-9);
}

// The other way round a pair keeps its direction from a to b.
TEST(CollideConvex, caches_the_direction_from_a_to_b) {
    const Geometry box = Box{}, ball = Sphere{0.5};
    const Convex a = convex_of(transformed_shape(box, {}), {});
    const Convex b = convex_of(transformed_shape(ball, {{0, 0, 3}, {}}), {});
    PairCache forth, back;
    find_witness(a, b, 1e300, forth);
    find_witness(b, a, 1e300, back);
    EXPECT_TRUE(near(forth.direction, {0, 0, 1}, 1e-9));
    EXPECT_TRUE(near(back.direction, {0, 0, -1}, 1e-9));
}

}  // namespace
}  // namespace jostle::test
