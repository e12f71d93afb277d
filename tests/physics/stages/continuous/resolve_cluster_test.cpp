// SPDX-License-Identifier: MIT
//
// An impact on a body that touches others is resolved with them, and only then.
#include "physics/src/stages/continuous/resolve_cluster.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double radius = 0.1;

BodyId add_ball(World& world, Vec3 at, Vec3 velocity = {}) {
    return add(world, {.geometry = Sphere{radius},
                       .position = at,
                       .velocity = velocity,
                       .friction = 0,
                       .restitution = 1});
}

// The struck ball touches two others, at +-30 degrees.
TEST(ResolveCluster, struck_ball_passes_equal_shares_to_its_neighbours) {
    World world = make_world({.gravity = {}, .sleeping = false});
    const BodyId cue = add_ball(world, {-0.3, 0, 0}, {6, 0, 0});
    const BodyId struck = add_ball(world, {});
    const double x = radius * square_root(3.0);
    const BodyId left = add_ball(world, {x, 0, radius}), right = add_ball(world, {x, 0, -radius});
    const double energy = world.summary().kinetic_energy;
    run(world, 0.1);
    const Vec3 a = velocity_of(world, left), b = velocity_of(world, right);
    EXPECT_TRUE(near(a, {b.x, 0, -b.z}, 1e-9));
    // It returns at a fifth of its speed and passes that back.
    EXPECT_NEAR(velocity_of(world, cue).x, -1.2, 1e-6);
    EXPECT_NEAR(velocity_of(world, struck).x, 0, 1e-6);
    EXPECT_NEAR(world.summary().kinetic_energy / energy, 1, 1e-6);
}

TEST(ResolveCluster, wakes_a_sleeping_row) {
    World world = make_world({.gravity = {}});
    std::vector<BodyId> row;
    for (int k = 0; k < 4; k++) row.push_back(add_ball(world, {0.2 * k, 0, 0}));
    run(world, 1);
    ASSERT_FALSE(state_of(world, row[3]).awake);
    add_ball(world, {-0.5, 0, 0}, {3, 0, 0});
    run(world, 0.5);
    EXPECT_NEAR(velocity_of(world, row[3]).x, 3, 1e-6);
    for (int k = 0; k < 3; k++)
        EXPECT_NEAR(velocity_of(world, row[static_cast<std::size_t>(k)]).x, 0, 1e-6) << k;
}

}  // namespace
}  // namespace jostle::test
