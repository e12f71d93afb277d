// SPDX-License-Identifier: MIT
//
// An island that sleeps takes its bodies and manifolds along, and wakes with the same.
#include "physics/src/state/island_sleep.h"

#include <gtest/gtest.h>

#include <map>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Boxes upon each other at x, in the first step after they met.
std::vector<BodyId> add_stack(World& world, int boxes, double x) {
    std::vector<BodyId> stack;
    for (int k = 0; k < boxes; k++) stack.push_back(add(world, {.position = {x, 0.5 + k, 0}}));
    return stack;
}

std::map<std::uint32_t, SavedContact> manifolds_of(const WorldState& state) {
    std::map<std::uint32_t, SavedContact> saved;
    for (std::uint32_t k = 0; k < state.contacts.ids.size(); k++)
        if (state.contacts.ids.alive(k) && state.contacts.contacts[k].colour >= 0)
            saved[k] = save_contact(state, k);
    return saved;
}

struct Stack {
    World world = make_world();
    WorldState& state = state_of(world);
    std::vector<BodyId> boxes;
    std::uint32_t island = 0;
    std::vector<ContactEnd> ended;

    explicit Stack(int count) {
        add_floor(world);
        boxes = add_stack(world, count, 0);
        run(world, 0.2);
        island = state.bodies.cold[boxes[0].index].island;
    }
    std::string fault() const { return find_fault(state).value_or(""); }
};

TEST(IslandSleep, round_trips_bodies_and_manifolds) {
    Stack stack(3);
    WorldState& state = stack.state;
    const auto before = manifolds_of(state);
    ASSERT_EQ(before.size(), 3u);
    const Vec3 top = warm_of(state, stack.boxes[2].index).center;

    put_island_to_sleep(state, stack.island, stack.ended);
    const Island& island = state.islands.islands[stack.island];
    EXPECT_TRUE(island.asleep);
    EXPECT_EQ(island.sleepers.size(), 3u);
    EXPECT_EQ(island.manifolds.size(), 3u);
    EXPECT_TRUE(state.bodies.awake.empty());
    for (const ColourSet& set : state.graph.sets) EXPECT_EQ(set.contacts, 0);
    EXPECT_EQ(warm_of(state, stack.boxes[2].index).center, top);
    EXPECT_EQ(warm_of(state, stack.boxes[2].index).v, Vec3{});
    EXPECT_EQ(state.bodies.cold[stack.boxes[0].index].constraints, 0u);
    EXPECT_EQ(stack.fault(), "");

    std::vector<BodyId> woke;
    wake_island(state, stack.island, woke);
    EXPECT_EQ(woke, stack.boxes);
    EXPECT_FALSE(island.asleep);
    EXPECT_EQ(state.bodies.awake.size(), 3u);
    const auto after = manifolds_of(state);
    ASSERT_EQ(after.size(), 3u);
    for (const auto& [contact, saved] : before) {
        EXPECT_EQ(after.at(contact).rows, saved.rows) << "contact " << contact;
        EXPECT_EQ(after.at(contact).moved, saved.moved);
    }
    EXPECT_EQ(stack.fault(), "");
    wake_island(state, stack.island, woke);
    EXPECT_EQ(woke.size(), 3u) << "who is awake does not wake";
}

// Sixteen or more wake asleep in place: who disturbs them wakes what that stirs.
TEST(IslandSleep, sixteen_bodies_wake_into_partial_sleep) {
    for (const int boxes : {15, 16}) {
        Stack stack(boxes);
        put_island_to_sleep(stack.state, stack.island, stack.ended);
        std::vector<BodyId> woke;
        wake_island(stack.state, stack.island, woke);
        const bool in_place = boxes == 16;
        EXPECT_EQ(woke.size(), in_place ? 0u : 15u);
        EXPECT_EQ(stack.state.bodies.asleep_in_place, in_place ? 16u : 0u);
        EXPECT_EQ(stack.state.bodies.awake.size(), static_cast<std::size_t>(boxes));
        EXPECT_EQ(stack.state.graph.sets[index_of(asleep_set)].contacts, in_place ? 16 : 0);
        EXPECT_EQ(stack.fault(), "");
    }
}

// What a kinematic body leads by a joint must not stay behind.
TEST(IslandSleep, body_jointed_to_a_kinematic_body_wakes) {
    Stack stack(20);
    const BodyId crane = add(stack.world, {.position = {0, 25, 0}, .type = BodyType::kinematic});
    must(stack.world.create_joint({.body_a = crane, .body_b = stack.boxes[19]}));
    put_island_to_sleep(stack.state, stack.island, stack.ended);
    std::vector<BodyId> woke;
    wake_island(stack.state, stack.island, woke);
    EXPECT_EQ(woke, std::vector{stack.boxes[19]});
    EXPECT_EQ(stack.state.bodies.asleep_in_place, 19u);
    EXPECT_EQ(stack.fault(), "");
}

// Two stacks a centimetre apart have manifolds between them and do not touch. When one sleeps and
// the other does not the pair waits; when both do it is dormant.
TEST(IslandSleep, manifolds_with_awake_bodies_end_and_become_dormant) {
    World world = make_world();
    add_floor(world);
    const BodyId left = add_stack(world, 1, 0)[0], right = add_stack(world, 1, 1.01)[0];
    run(world, 0.2);
    WorldState& state = state_of(world);
    const auto island = [&](BodyId body) { return state.bodies.cold[body.index].island; };
    ASSERT_NE(island(left), island(right));
    std::uint32_t between = none;
    for (std::uint32_t k = 0; k < state.contacts.ids.size(); k++)
        if (is_dynamic(state.bodies, state.contacts.contacts[k].body_b)) between = k;
    ASSERT_NE(between, none);
    const Contact& contact = state.contacts.contacts[between];
    std::vector<ContactEnd> ended;
    ASSERT_GE(contact.colour, 0);
    put_island_to_sleep(state, island(left), ended);
    EXPECT_LT(contact.colour, 0);
    EXPECT_TRUE(contact.has_bound);
    EXPECT_FALSE(contact.dormant);
    EXPECT_EQ(find_fault(state), std::nullopt);
    put_island_to_sleep(state, island(right), ended);
    EXPECT_TRUE(contact.dormant);
    EXPECT_TRUE(ended.empty()) << "they never touched";
    EXPECT_EQ(find_fault(state), std::nullopt);
    std::vector<BodyId> woke;
    wake_island(state, island(left), woke);
    EXPECT_FALSE(contact.dormant);
    EXPECT_TRUE(contact.has_bound);
    EXPECT_EQ(find_fault(state), std::nullopt);
}

}  // namespace
}  // namespace jostle::test
