// SPDX-License-Identifier: MIT
//
// Which pairs the narrow phase looks at.
#include "physics/src/stages/contacts/contact_stages.h"

#include <gtest/gtest.h>

#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/separation_bounds.h"
#include "physics/src/state/world_access.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Choice {
    World& world;
    WorldState& state = state_of(world);
    StepScratch scratch;
    explicit Choice(World& w) : world(w) {
        StepContext step{state, scratch, *state.thread_pool, dt, {}};
        select_pairs(step);
    }
    ~Choice() {
        for (const NarrowPhaseTask& check : scratch.contacts.tasks)
            state.contacts.contacts[check.contact].queued = false;
    }
    std::vector<std::uint32_t> contacts() const {
        std::vector<std::uint32_t> chosen;
        for (const NarrowPhaseTask& check : scratch.contacts.tasks) chosen.push_back(check.contact);
        return chosen;
    }
};
using Contacts = std::vector<std::uint32_t>;

TEST(SelectPairs, selects_new_pairs_and_skips_resting_pairs) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    WorldState& state = state_of(world);
    const std::uint32_t contact = create_contact(state, 1, 0);
    {
        const Choice choice(world);
        EXPECT_EQ(choice.contacts(), Contacts{contact});
        EXPECT_TRUE(state.contacts.bounds.empty()) << "taken off the list";
        EXPECT_EQ(choice.scratch.contacts.had_contacts, std::vector<std::uint8_t>{0});
    }
    add_separation_bound(state, state.contacts, contact, -1);
    run(world, 2);
    const Choice at_rest(world);
    EXPECT_EQ(at_rest.contacts(), Contacts{}) << "its manifold is kept";
    EXPECT_EQ(at_rest.scratch.contacts.had_contacts, std::vector<std::uint8_t>{1});
}

TEST(SelectPairs, selects_a_moved_manifold_once) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int k = 0; k < 3; k++) add(world, {.position = {3.0 * k, 0.5, 0}});
    run(world, 2);
    WorldState& state = state_of(world);
    const std::uint32_t second = state.bodies.cold[2].first_edge / 2;
    const ContactLaneRef place = lane_ref_of(state.graph, state.contacts.contacts[second]);
    place.meta->set(LaneFlag::needs_rebuild, place.lane, true);
    EXPECT_EQ(Choice(world).contacts(), Contacts{second});
}

// A dumbbell on the floor has two manifolds; both moved too far, and the pair is looked at as one.
TEST(SelectPairs, selects_a_composite_pair_once) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const Geometry dumbbell = Compound{must(build_compound(
        {{Sphere{0.5}, {.position = {1, 0, 0}}}, {Sphere{0.5}, {.position = {-1, 0, 0}}}}))};
    add(world, {.geometry = dumbbell, .position = {0, 0.5, 0}});
    run(world, 1);
    WorldState& state = state_of(world);
    std::uint32_t pair = none;
    int parts = 0;
    for_each_contact(state.contacts, state.bodies.cold[1], [&](std::uint32_t index) {
        const Contact& c = state.contacts.contacts[index];
        if (c.composite) pair = index;
        if (c.colour < 0) return;
        parts++;
        const ContactLaneRef place = lane_ref_of(state.graph, c);
        place.meta->set(LaneFlag::needs_rebuild, place.lane, true);
    });
    ASSERT_EQ(parts, 2);
    const Choice choice(world);
    EXPECT_EQ(choice.contacts(), Contacts{pair});
    EXPECT_EQ(choice.scratch.contacts.child_list_count, 1);
}

// What sleeps on both sides needs no bound; its limit is kept for when it wakes.
TEST(SelectPairs, removes_dormant_pairs) {
    World world = make_world();
    add(world, {.position = {0, 0, 0}});
    add(world, {.position = {9, 0, 0}});
    WorldState& state = state_of(world);
    const std::uint32_t contact = create_contact(state, 0, 1);
    Contact& c = state.contacts.contacts[contact];
    c.dormant = state.contacts.some_dormant = true;
    state.contacts.bounds[0].limit = 7;
    EXPECT_EQ(Choice(world).contacts(), Contacts{});
    EXPECT_TRUE(state.contacts.bounds.empty());
    EXPECT_FALSE(c.has_bound);
    EXPECT_EQ(c.limit, 7);
}

}  // namespace
}  // namespace jostle::test
