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
