// SPDX-License-Identifier: MIT
//
// Islands change their tier, and what they bear stays what it was.
#include "physics/src/state/island_tiers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr ColourSetKey tall{SolverTier::tall, 0}, low{SolverTier::low, 0};

// Three boxes upon each other, and one box beside them: a gap of 1 cm is near enough for a
// manifold, 1 m is not.
struct StackAndNeighbour {
    World world = make_world({.sleeping = false});
    WorldState& state = state_of(world);
    BodyId lowest, beside;
    std::uint32_t island = 0, other = 0;

    explicit StackAndNeighbour(double gap) {
        add_floor(world);
        for (int k = 0; k < 3; k++) {
            const BodyId box = add(world, {.position = {0, 0.5 + k, 0}});
            if (k == 0) lowest = box;
        }
        beside = add(world, {.position = {1 + gap, 0.5, 0}});
        run(world, 1);
        island = state.bodies.cold[lowest.index].island;
        other = state.bodies.cold[beside.index].island;
    }
    // The contact of a box with the floor.
    const Contact& on_floor(BodyId box) const {
        const Contact* found = nullptr;
        for_each_contact(state.contacts, state.bodies.cold[box.index], [&](std::uint32_t index) {
            const Contact& c = state.contacts.contacts[index];
            if (!is_dynamic(state.bodies, c.body_b)) found = &c;
        });
        return *found;
    }
    double impulse(BodyId box) {
        const ContactLaneRef place = lane_ref_of(state.graph, on_floor(box));
        double sum = 0;
        for (const auto& lambda : place.block->lambda) sum += double{lambda[place.lane]};
        return sum;
    }
};

TEST(IslandTiers, manifolds_couple_islands_that_do_not_touch) {
    const StackAndNeighbour near(0.01), far(1);
    ASSERT_NE(near.island, near.other);
    EXPECT_EQ(coupled_islands(near.state, near.state.contacts, near.island),
              (std::vector<std::uint32_t>{near.island, near.other}));
    EXPECT_EQ(coupled_islands(far.state, far.state.contacts, far.island), std::vector{far.island});
}

// A row of stacks, some of which are near enough to the next for a manifold: looked for all at once
// each island has the same company as when it is looked for alone.
TEST(IslandTiers, couplings_of_all_islands_match_those_of_each) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    double x = 0;
    for (const double gap : {0.01, 1.0, 0.01, 0.01, 1.0, 1.0, 0.01}) {
        for (int k = 0; k < 2; k++) add(world, {.position = {x, 0.5 + k, 0}});
        x += 1 + gap;
    }
    run(world, 1);
    const WorldState& state = state_of(world);
    const CoupledIslands all(state);
    std::set<std::size_t> sizes;
    for (std::uint32_t i = 0; i < state.islands.ids.size(); i++) {
        if (!state.islands.ids.alive(i)) continue;
        std::vector<std::uint32_t> alone = coupled_islands(state, state.contacts, i);
        std::sort(alone.begin(), alone.end());
        const auto group = all.group_of(i);
        EXPECT_EQ(std::vector(group.begin(), group.end()), alone) << "island " << i;
        const auto bodies = static_cast<std::uint32_t>(2 * alone.size());  // stacks of two
        std::vector<std::uint32_t> few = few_coupled_islands(state, state.contacts, i, bodies);
        std::sort(few.begin(), few.end());
        EXPECT_EQ(few, alone) << "island " << i;
        EXPECT_TRUE(few_coupled_islands(state, state.contacts, i, bodies - 1).empty());
        sizes.insert(alone.size());
    }
    EXPECT_GT(sizes.size(), 2u) << "some alone, some with one and some with two others";
}

// From 4 or 8 sub-steps to 16: each bears its part of the same 29430 N.
TEST(IslandTiers, impulses_scale_with_the_substep_length) {
    StackAndNeighbour stack(1);
    const ColourSetKey before = stack.state.islands.islands[stack.island].colour_set;
    const int substeps = substeps_of(before.tier, stack.state.def);
    const Vec3 load = load_of(stack.state, stack.on_floor(stack.lowest));
    ASSERT_TRUE(near(load, {0, -3 * 9810, 0}, 100));
    const double impulse = stack.impulse(stack.lowest);
    stack.state.islands.islands[stack.island].calm = 2;
    move_to_set(stack.state, stack.state.joints, std::array{stack.island}, tall);
    EXPECT_NEAR(stack.impulse(stack.lowest), impulse * substeps / 16, 1e-5 * impulse);
    EXPECT_TRUE(near(load_of(stack.state, stack.on_floor(stack.lowest)), load, 0.1));
    EXPECT_EQ(stack.state.islands.islands[stack.island].calm, 0);
    EXPECT_EQ(stack.on_floor(stack.lowest).colour_set, tall);
    EXPECT_NE(stack.on_floor(stack.beside).colour_set, tall) << "its neighbour stays";
    EXPECT_EQ(find_fault(stack.state), std::nullopt);
}

TEST(IslandTiers, removing_a_load_does_not_throw_bodies_up) {
    StackAndNeighbour stack(1);
    const double stack_bears = stack.impulse(stack.lowest), alone = stack.impulse(stack.beside);
    scale_warm_start(stack.state, stack.state.islands.islands[stack.island], 0.25f);
    EXPECT_NEAR(stack.impulse(stack.lowest), 0.25 * stack_bears, 1e-6 * stack_bears);
    EXPECT_EQ(stack.impulse(stack.beside), alone);
}

// Of two that will be one the greater tier counts; of two that ask for much the same the larger
// island's.
TEST(IslandTiers, lower_tier_joins_the_set_of_the_higher_tier) {
    StackAndNeighbour stack(1);
    move_to_set(stack.state, stack.state.joints, std::array{stack.island}, low);
    move_to_set(stack.state, stack.state.joints, std::array{stack.other}, tall);
    match_sets(stack.state, stack.state.joints, stack.island, stack.other);
    EXPECT_EQ(stack.state.islands.islands[stack.island].colour_set, tall);
    EXPECT_EQ(find_fault(stack.state), std::nullopt);

    StackAndNeighbour usual(1);
    const ColourSetKey slender{SolverTier::slender, 0};
    move_to_set(usual.state, usual.state.joints, std::array{usual.island}, low);
    move_to_set(usual.state, usual.state.joints, std::array{usual.other}, slender);
    match_sets(usual.state, usual.state.joints, usual.island, usual.other);
    EXPECT_EQ(usual.state.islands.islands[usual.other].colour_set, low) << "three boxes to one";
}

// A ball that left a tall heap was content with less at the last look: it does not make the next
// heap tall.
TEST(IslandTiers, calm_island_requires_at_most_slender) {
    StackAndNeighbour stack(1);
    move_to_set(stack.state, stack.state.joints, std::array{stack.island}, low);
    move_to_set(stack.state, stack.state.joints, std::array{stack.other}, tall);
    stack.state.islands.islands[stack.other].calm = 1;
    match_sets(stack.state, stack.state.joints, stack.island, stack.other);
    EXPECT_EQ(stack.state.islands.islands[stack.island].colour_set, low);
    EXPECT_EQ(stack.state.islands.islands[stack.other].colour_set, low);
    EXPECT_EQ(find_fault(stack.state), std::nullopt);
}

}  // namespace
}  // namespace jostle::test
