// SPDX-License-Identifier: MIT
//
// The force at a contact is what rests on it.
#include "physics/src/state/contact_load.h"

#include <gtest/gtest.h>

#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// The one contact of a body that rests on something.
std::uint32_t contact_of(const WorldState& state, BodyId body) {
    return state.bodies.cold[body.index].first_edge / 2;
}
Vec3 load_on(const World& world, BodyId body) {
    const WorldState& state = state_of(world);
    return load_of(state, state.contacts.contacts[contact_of(state, body)]);
}

// A tonne presses the floor, side b, with 9810 N, whatever the length of a sub-step.
TEST(ContactLoad, resting_box_load_is_its_weight) {
    for (const int substeps : {4, 8, 16}) {
        World world = make_world({.substeps = substeps, .sleeping = false});
        add_floor(world);
        const BodyId box = add(world, {.position = {0, 0.5, 0}});
        run(world, 2);
        EXPECT_TRUE(near(load_on(world, box), {0, -9810, 0}, 10)) << substeps;
    }
}

// On a slope of 0.3 friction is a part of it: the sum is still the weight.
TEST(ContactLoad, includes_friction_on_a_slope) {
    const Vec3 gravity = leaning_gravity(0.3, 0.5);
    World world = make_world({.gravity = gravity, .sleeping = false});
    add_floor(world, 0.9);
    const BodyId box =
        add(world, {.geometry = Box{{0.5, 0.1, 0.5}}, .position = {0, 0.1, 0}, .friction = 0.9});
    run(world, 3);
    EXPECT_TRUE(near(load_on(world, box), gravity * 200, 10));
}

TEST(ContactLoad, saved_load_is_the_supported_mass) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    WorldState& state = state_of(world);
    const std::uint32_t contact = contact_of(state, box);
    EXPECT_EQ(saved_load(state.contacts.contacts[contact]), Vec3{});
    save_load(state, contact);
    EXPECT_NEAR(supported_mass(state.def, state.contacts.contacts[contact]), 1000, 1);
    state.def.gravity = {};
    EXPECT_EQ(supported_mass(state.def, state.contacts.contacts[contact]), 0)
        << "without gravity it is nobody's weight";
}

}  // namespace
}  // namespace jostle::test
