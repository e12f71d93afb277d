// SPDX-License-Identifier: MIT
//
// Which shapes a TOI body is swept against.
#include "physics/src/stages/continuous/toi_policy.h"

#include <gtest/gtest.h>

#include "tests/physics/stages/continuous/toi_scene.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ToiPolicy, ignored_pair_does_not_collide) {
    ToiScene scene;
    const std::uint32_t a = scene.ball(0), b = scene.ball(1), c = scene.ball(2);
    ToiState& state = scene.begin();
    EXPECT_TRUE(may_hit(state, a, b));
    EXPECT_FALSE(may_hit(state, a, a)) << "shapes of one body";
    ignore_pair(state, c, b);
    ignore_pair(state, b, a);
    EXPECT_FALSE(may_hit(state, a, b)) << "in either order";
    EXPECT_FALSE(may_hit(state, b, c));
    EXPECT_TRUE(may_hit(state, a, c));
}

// Half of the sum of the radii of two balls of 0.1 m, times 0.8.
TEST(ToiPolicy, displacement_below_the_sweep_limit_is_left_to_contacts) {
    ToiScene scene;
    const std::uint32_t a = scene.ball(0), b = scene.ball(1), c = scene.ball(2);
    ToiState& state = scene.begin();
    const std::size_t slow = scene.moving(a, 0.079), fast = scene.moving(b, 0.081);
    EXPECT_FALSE(needs_sweep(state, state.bodies[slow], c));
    EXPECT_TRUE(needs_sweep(state, state.bodies[fast], c));
    EXPECT_FALSE(needs_sweep(state, state.bodies[fast], a)) << "2 mm relative to each other";
    state.bodies[slow].changed = true;
    EXPECT_TRUE(needs_sweep(state, state.bodies[slow], c)) << "contacts did not predict its path";
}

TEST(ToiPolicy, rejects_bodies_whose_spheres_stay_apart) {
    ToiScene scene({.gravity = {}});
    const std::uint32_t a = scene.ball(0), near = scene.ball(1), far = scene.ball(3);
    ToiState& state = scene.begin();
    ToiBody& t = state.bodies[scene.moving(a, 2)];
    EXPECT_FALSE(spheres_miss(state, t, near));
    EXPECT_TRUE(spheres_miss(state, t, far)) << "0.8 m before it at the end of the step";
    t.fraction = 0.3;
    EXPECT_TRUE(spheres_miss(state, t, near)) << "an earlier impact is known";
}

// 0.5^3 is above a tenth, 0.5^4 is not.
TEST(ToiPolicy, impact_chain_ends_at_a_tenth_of_the_speed) {
    ToiScene scene;
    const std::uint32_t a = scene.ball(0, 0.5), b = scene.ball(0.2, 0.5);
    ToiState& state = scene.begin();
    ToiBody& t = state.bodies[scene.moving(a, 1)];
    t.impact_chain_length = 3;
    EXPECT_TRUE(continues_impact_chain(state, t, a, b));
    t.impact_chain_length = 4;
    EXPECT_FALSE(continues_impact_chain(state, t, a, b));
}

}  // namespace
}  // namespace jostle::test
