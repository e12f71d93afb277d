// SPDX-License-Identifier: MIT
//
// Volume, centre and inertia of polyhedra against closed forms, wherever they stand.
#include "physics/src/geometry/hull_builder.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A brick of 2 x 4 x 6 m in any pose has m / 12 (b^2 + c^2) about each of its own axes.
TEST(PolyhedronMass, matches_a_box_in_any_pose) {
    Random random(51);
    for (int round = 0; round < 20; round++) {
        const Transform pose{random.vector(100), random.rotation()};
        std::vector<Vec3> corners;
        for (int k = 0; k < 8; k++)
            corners.push_back(
                apply(pose, {k & 1 ? 1.0 : -1.0, k & 2 ? 2.0 : -2.0, k & 4 ? 3.0 : -3.0}));
        const PolyhedronMass brick = polyhedron_mass(*must(build_hull(corners)));
        EXPECT_NEAR(brick.volume, 48, 1e-9);
        EXPECT_TRUE(near(brick.center, pose.position, 1e-9));
        const Mat3 axes = to_matrix(pose.rotation);
        EXPECT_TRUE(near(brick.inertia * axes.x, axes.x * (4 * (16 + 36)), 1e-7));
        EXPECT_TRUE(near(brick.inertia * axes.y, axes.y * (4 * (4 + 36)), 1e-7));
        EXPECT_TRUE(near(brick.inertia * axes.z, axes.z * (4 * (4 + 16)), 1e-7));
    }
}

// A pyramid of height 3 on a square of 2 m: a third of the prism, its centre a quarter up.
TEST(PolyhedronMass, matches_the_closed_form_of_a_pyramid) {
    const PolyhedronMass pyramid = polyhedron_mass(*must(
        build_hull(std::vector<Vec3>{{1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {-1, 0, 1}, {0, 3, 0}})));
    EXPECT_NEAR(pyramid.volume, 4, 1e-12);
    EXPECT_TRUE(near(pyramid.center, {0, 0.75, 0}, 1e-12));
    EXPECT_NEAR(pyramid.inertia.y.y, 4 * (4 + 4) / 20.0, 1e-12);
}

}  // namespace
}  // namespace jostle::test
