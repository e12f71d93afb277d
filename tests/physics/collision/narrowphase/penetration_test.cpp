// SPDX-License-Identifier: MIT
//
// The least way to part two overlapping cores.
#include "physics/src/collision/narrowphase/penetration.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/placed_convex.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

Penetration between(const Convex& a, const Convex& b) {
    const GjkResult g = gjk(a, b, {});
    EXPECT_EQ(g.distance, 0);
    return penetration(a, b, g.simplex);
}

TEST(Penetration, depth_of_overlapping_cubes_is_exact) {
    const Geometry cube = Box{{1, 1, 1}};
    const Penetration p = between(at(cube, {}), at(cube, {0.3, 1.9, -0.2}));
    EXPECT_NEAR(p.depth, 0.1, 1e-9);
    EXPECT_TRUE(near(p.normal, {0, 1, 0}, 1e-6));
    EXPECT_NEAR(p.on_a.y, 1, 1e-6);
    EXPECT_NEAR(p.on_b.y, 0.9, 1e-6);
}

// Two cylinders that cross at a right angle, axes 1.5 m apart: half a metre deep.
TEST(Penetration, depth_of_crossing_cylinders_is_exact) {
    const Geometry log = Cylinder{1, 5};
    const Penetration p =
        between(at(log, {}), at(log, {1.5, 0, 0}, from_axis_angle({1, 0, 0}, pi / 2)));
    EXPECT_NEAR(p.depth, 0.5, 1e-3);
    EXPECT_NEAR(p.normal.x, 1, 1e-3);
}

// Random pairs: moved by the depth along the normal they touch, and no direction parts them sooner.
TEST(Penetration, is_the_shortest_separating_translation) {
    Random random(111);
    constexpr ShapeKind kinds[] = {ShapeKind::box, ShapeKind::cylinder, ShapeKind::cone,
                                   ShapeKind::hull};
    int overlapping = 0;
    for (int round = 0; round < 1000; round++) {
        const Geometry ga = random_geometry(kinds[random.below(4)], random);
        const Geometry gb = random_geometry(kinds[random.below(4)], random);
        const Convex a = at(ga, {}, random.rotation());
        const Convex b = at(gb, random.vector(1), random.rotation());
        const GjkResult g = gjk(a, b, {});
        if (g.distance > 0) continue;
        overlapping++;
        const Penetration p = penetration(a, b, g.simplex);
        const double size = minimum(size_of(a), size_of(b));
        const double overlap = dot(support(a, p.normal) - support(b, -p.normal), p.normal);
        EXPECT_NEAR(p.depth, overlap, 2e-3 * size) << round;
        for (int k = 0; k < 300; k++) {
            const Vec3 d = random.direction();
            ASSERT_GE(dot(support(a, d) - support(b, -d), d), p.depth - 2e-3 * size) << round;
        }
    }
    EXPECT_GT(overlapping, 300);
}

}  // namespace
}  // namespace jostle::test
