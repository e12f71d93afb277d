// SPDX-License-Identifier: MIT
//
// Sets stay contiguous: the last body moves into the hole, and all who name it by its place know.
#include "physics/src/state/body_sets.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(BodySets, last_body_fills_the_hole) {
    World world = make_world();
    std::vector<BodyId> bodies;
    for (int k = 0; k < 4; k++) bodies.push_back(add(world, {.position = {3.0 * k, 0, 0}}));
    WorldState& state = state_of(world);
    const BodyWarm second = warm_of(state, bodies[1].index);
    leave_set(state, bodies[1].index);
    ASSERT_EQ(state.bodies.awake.size(), 3u);
    EXPECT_EQ(state.bodies.cold[bodies[3].index].at, 1u);
    EXPECT_EQ(warm_of(state, bodies[3].index).center.x, 9);
    EXPECT_EQ(state.bodies.cold[bodies[2].index].at, 2u) << "the others stay where they are";
    enter_awake(state.bodies, second);
    EXPECT_EQ(state.bodies.cold[bodies[1].index].at, 3u);
    EXPECT_EQ(warm_of(state, bodies[1].index).center.x, 3);
    leave_set(state, bodies[1].index);  // the last one leaves no hole
    EXPECT_EQ(state.bodies.awake.size(), 3u);
    EXPECT_EQ(warm_of(state, bodies[3].index).center.x, 9);
    enter_awake(state.bodies, second);
    EXPECT_EQ(find_fault(state), std::nullopt);
}

// Lanes name bodies by their places in the awake set, plus one.
TEST(BodySets, moving_a_body_updates_its_lanes) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 3; k++) boxes.push_back(add(world, {.position = {3.0 * k, 0.5, 0}}));
    run(world, 0.2);
    WorldState& state = state_of(world);
    const auto hot_index = [&](BodyId box) {
        const Contact& c = state.contacts.contacts[state.bodies.cold[box.index].first_edge / 2];
        const ContactLaneRef place = lane_ref_of(state.graph, c);
        return place.block->a[place.lane];
    };
    EXPECT_EQ(hot_index(boxes[2]), 3);
    must(world.destroy_body(boxes[0]));
    EXPECT_EQ(hot_index(boxes[2]), 1);
    EXPECT_EQ(hot_index(boxes[1]), 2);
    EXPECT_EQ(find_fault(state), std::nullopt);
}

TEST(BodySets, static_bodies_have_their_own_set) {
    World world = make_world();
    const BodyId wall = add_static(world, {.position = {1, 0, 0}});
    const BodyId box = add(world, {.position = {5, 0, 0}});
    const BodyId second_wall = add_static(world, {.position = {2, 0, 0}});
    WorldState& state = state_of(world);
    EXPECT_EQ(state.bodies.cold[second_wall.index].at, 1u);
    EXPECT_EQ(state.bodies.cold[box.index].at, 0u);
    const BodyWarm warm = warm_of(state, wall.index);
    leave_set(state, wall.index);
    EXPECT_EQ(state.bodies.cold[second_wall.index].at, 0u);
    EXPECT_EQ(state.bodies.awake.size(), 1u);
    enter_static(state.bodies, warm);
    EXPECT_EQ(warm_of(state, wall.index).center.x, 1);
    EXPECT_EQ(find_fault(state), std::nullopt);
}

}  // namespace
}  // namespace jostle::test
