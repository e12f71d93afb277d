// SPDX-License-Identifier: MIT
//
// Bodies that sleep in place keep their place and are nobody's to solve, until they wake as they
// fell asleep.
#include "physics/src/state/partial_sleep.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Five boxes of a tonne upon each other, at rest.
struct HeavyStack {
    World world = make_world({.sleeping = false});
    WorldState& state = state_of(world);
    std::vector<std::uint32_t> boxes;
    std::vector<BodyId> woke;

    HeavyStack() {
        add_floor(world);
        for (int k = 0; k < 5; k++)
            boxes.push_back(add(world, {.position = {0, 0.5 + k, 0}}).index);
        run(world, 3);
    }
    bool asleep(std::size_t box) const { return state.bodies.cold[boxes[box]].asleep_in_place; }
    // The contact below a box.
    std::uint32_t below(std::size_t box) const {
        const std::uint32_t lower = box == 0 ? 0 : boxes[box - 1];  // the floor is body 0
        std::uint32_t found = none;
        for_each_contact(state.contacts, state.bodies.cold[boxes[box]], [&](std::uint32_t index) {
            const Contact& c = state.contacts.contacts[index];
            if (c.body_a == lower || c.body_b == lower) found = index;
        });
        return found;
    }
    const Contact& contact(std::uint32_t index) const { return state.contacts.contacts[index]; }
    // 1/kg of the two boxes of a contact together, as its lane says.
    float inverse_mass(std::uint32_t index) {
        const ContactLaneRef place = lane_ref_of(state.graph, contact(index));
        return place.block->g[0][place.lane];
    }
    std::string fault() const { return find_fault(state).value_or(""); }
};

TEST(PartialSleep, contacts_between_sleeping_bodies_leave_the_solver) {
    HeavyStack stack;
    warm_of(stack.state, stack.boxes[0]).v = {0.01, 0, 0};
    sleep_in_place(stack.state, std::vector{stack.boxes[0], stack.boxes[1], stack.boxes[2]});
    EXPECT_EQ(stack.state.bodies.asleep_in_place, 3u);
    EXPECT_EQ(warm_of(stack.state, stack.boxes[0]).v, Vec3{});
    for (const std::size_t box : {0u, 1u, 2u})
        EXPECT_EQ(stack.contact(stack.below(box)).colour_set, asleep_set);
    EXPECT_NE(stack.contact(stack.below(3)).colour_set, asleep_set) << "one of the two moves";
    EXPECT_EQ(stack.state.bodies.awake.size(), 5u) << "all keep their places";
    EXPECT_EQ(stack.fault(), "");
}

// For its neighbour that moves it is as good as static: half the mobility at their contact is gone.
TEST(PartialSleep, sleeping_body_acts_as_static) {
    HeavyStack stack;
    const std::uint32_t between = stack.below(3);
    const float both = stack.inverse_mass(between);
    sleep_in_place(stack.state, std::vector{stack.boxes[2]});
    EXPECT_NEAR(stack.inverse_mass(between), both / 2, 1e-6 * double{both});
    wake_in_place(stack.state, stack.boxes[2]);
    EXPECT_NEAR(stack.inverse_mass(between), both, 1e-6 * double{both});
    EXPECT_EQ(stack.fault(), "");
}

// What it bore is kept, to compare with: four boxes on the lowest.
TEST(PartialSleep, saves_the_forces_at_contacts) {
    HeavyStack stack;
    sleep_in_place(stack.state, std::vector{stack.boxes[0]});
    EXPECT_NEAR(supported_mass(stack.state.def, stack.contact(stack.below(1))), 4000, 40);
    EXPECT_NEAR(supported_mass(stack.state.def, stack.contact(stack.below(0))), 5000, 50);
}

TEST(PartialSleep, waking_one_body_keeps_its_rest_time) {
    HeavyStack stack;
    sleep_in_place(stack.state, stack.boxes);
    warm_of(stack.state, stack.boxes[4]).sleep_time = 9;
    wake_in_place(stack.state, stack.boxes[4]);
    EXPECT_FALSE(stack.asleep(4));
    EXPECT_TRUE(stack.asleep(3));
    EXPECT_EQ(warm_of(stack.state, stack.boxes[4]).sleep_time, 9);
    EXPECT_EQ(stack.state.bodies.asleep_in_place, 4u);
    wake_in_place(stack.state, stack.boxes[4]);
    EXPECT_EQ(stack.state.bodies.asleep_in_place, 4u) << "twice is once";
    EXPECT_EQ(stack.fault(), "");
}

TEST(PartialSleep, jointed_bodies_wake_together) {
    HeavyStack stack;
    must(stack.world.create_joint({.body_a = body_id(stack.state.bodies, stack.boxes[1]),
                                   .body_b = body_id(stack.state.bodies, stack.boxes[3])}));
    sleep_in_place(stack.state, stack.boxes);
    for (const std::uint32_t box : stack.boxes) warm_of(stack.state, box).sleep_time = 9;
    wake_from_partial_sleep(stack.state, stack.boxes[3], stack.woke);
    EXPECT_EQ(stack.woke, (std::vector{body_id(stack.state.bodies, stack.boxes[1]),
                                       body_id(stack.state.bodies, stack.boxes[3])}));
    EXPECT_EQ(warm_of(stack.state, stack.boxes[1]).sleep_time, 0);
    EXPECT_TRUE(stack.asleep(2)) << "it lies between them and is not tied";
    wake_from_partial_sleep(stack.state, stack.boxes[3], stack.woke);
    EXPECT_EQ(stack.woke.size(), 2u) << "who is awake does not wake";
}

// Half a second of rest is what it takes; 8 steps before that it goes on counting.
TEST(PartialSleep, briefly_woken_body_sleeps_again_soon) {
    HeavyStack stack;
    sleep_in_place(stack.state, stack.boxes);
    for (const std::uint32_t box : stack.boxes) warm_of(stack.state, box).sleep_time = 9;
    wake_briefly(stack.state, stack.boxes[2], stack.woke);
    EXPECT_NEAR(warm_of(stack.state, stack.boxes[2]).sleep_time, 0.5 - 8 / 60.0, 1e-12);
    EXPECT_EQ(stack.woke.size(), 1u);
}

// An impact that stirs two and a half tonnes wakes the box that was hit and its neighbours on both
// sides, no more.
TEST(PartialSleep, wakes_the_requested_mass_around_the_body) {
    HeavyStack stack;
    sleep_in_place(stack.state, stack.boxes);
    for (const std::uint32_t box : stack.boxes) warm_of(stack.state, box).sleep_time = 9;
    wake_around(stack.state, stack.boxes[2], 2500, stack.woke);
    EXPECT_TRUE(stack.asleep(0));
    EXPECT_FALSE(stack.asleep(1));
    EXPECT_FALSE(stack.asleep(2));
    EXPECT_FALSE(stack.asleep(3));
    EXPECT_TRUE(stack.asleep(4));
    EXPECT_EQ(stack.woke.size(), 3u);
    EXPECT_EQ(warm_of(stack.state, stack.boxes[2]).sleep_time, 0);
    EXPECT_NEAR(warm_of(stack.state, stack.boxes[1]).sleep_time, 0.5 - 8 / 60.0, 1e-12)
        << "briefly";
    wake_around(stack.state, stack.boxes[0], 0, stack.woke);
    EXPECT_FALSE(stack.asleep(0));
    EXPECT_TRUE(stack.asleep(4));
    EXPECT_EQ(stack.fault(), "");
}

}  // namespace
}  // namespace jostle::test
