// SPDX-License-Identifier: MIT
//
// How far two bodies may move against each other in a step.
#include "physics/src/stages/contacts/pair_motion.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_graph.h"
#include "physics/src/state/world_access.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Two balls of 0.5 m that fly along with each other, 6 m/s apart, and one of them spins.
TEST(PairMotion, max_closing_distance_includes_velocity_and_both_rotations) {
    World world = make_world();
    add(world, {.geometry = Sphere{0.5}, .velocity = {100, 6, 0}});
    add(world, {.geometry = Sphere{0.5},
                .position = {5, 0, 0},
                .velocity = {100, 0, 0},
                .spin = {0, 24, 0}});
    WorldState& state = state_of(world);
    const std::uint32_t contact = create_contact(state, 0, 1);
    EXPECT_NEAR(max_closing_distance(state, state.contacts.contacts[contact], dt), (6 + 12) * dt,
                1e-12);
}

// A wall a hundred metres wide does not turn, however far its corners are.
TEST(PairMotion, static_bodies_add_no_motion) {
    World world = make_world();
    add(world, {.geometry = Sphere{0.5}, .velocity = {0, -3, 0}});
    add_static(world, {.geometry = Box{{100, 1, 100}}, .position = {0, -5, 0}});
    WorldState& state = state_of(world);
    const std::uint32_t contact = create_contact(state, 0, 1);
    EXPECT_NEAR(max_closing_distance(state, state.contacts.contacts[contact], dt), 3 * dt, 1e-12);
    EXPECT_EQ(motion_of(state, 0).v, (Vec3{0, -3, 0}));
}

}  // namespace
}  // namespace jostle::test
