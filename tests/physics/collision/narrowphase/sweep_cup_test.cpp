// SPDX-License-Identifier: MIT
//
// What a round shape's cup hides was not touched before, by the distances of GJK along the way.
#include "physics/src/collision/narrowphase/sweep_cup.h"

#include <gtest/gtest.h>

#include "physics/src/collision/narrowphase/gjk.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

Geometry round_shape(Random& random, int kind) {
    if (kind == 0) return Sphere{random.in(0.2, 0.5)};
    if (kind == 1) return Capsule{random.in(0.2, 0.5), random.in(0.05, 0.5)};
    return Cylinder{random.in(0.2, 0.5), random.in(0.05, 0.3)};
}

TEST(SweepCup, excludes_only_triangles_that_the_sweep_does_not_touch) {
    Random random(9);
    int hidden[3] = {}, shown[3] = {};
    for (int round = 0; round < 6000; round++) {
        const int kind = round % 3;
        const Geometry geometry = round_shape(random, kind);
        const Convex start = convex_of(transformed_shape(geometry, {{}, random.rotation()}), {});
        const Vec3 n = normalized(random.vector(1));
        const Vec3 motion = -n * random.in(0.1, 1) + random.vector(0.3);
        const Vec3 end = motion;
        const Vec3 touch = support(start, -n) - n * start.radius + end;
        SweepCup cup;
        cup.put(start, middle_of(start), motion, touch, n, 1e-6);
        const Vec3 at = touch + random.vector(0.4);
        const Vec3 corner[3] = {at, at + random.vector(0.4), at + random.vector(0.4)};
        if (!cup.hides(corner)) {
            shown[kind]++;
            continue;
        }
        hidden[kind]++;
        for (int k = 0; k <= 20; k++) {
            Convex there = start;
            there.position += motion * (k / 20.0);
            const double apart =
                gjk(triangle_convex(corner, {}, {}), there, {}).distance - start.radius;
            ASSERT_GT(apart, -1e-9) << "round " << round << " at " << k;
        }
    }
    for (const int count : hidden) EXPECT_GT(count, 100);
    for (const int count : shown) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace jostle::test
