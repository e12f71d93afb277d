// SPDX-License-Identifier: MIT
//
// Islands join, part and keep count of their bodies and mass.
#include "physics/src/state/islands.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_graph.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using Bodies = std::vector<std::uint32_t>;

// Boxes of 1000 kg in empty space, 3 m apart, each an island of its own index.
struct Row {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);

    explicit Row(int count) {
        for (int k = 0; k < count; k++) add(world, {.position = {3.0 * k, 0, 0}});
    }
    Island& island(std::uint32_t index) { return state.islands.islands[index]; }
    std::uint32_t island_of(std::uint32_t body) const { return state.bodies.cold[body].island; }
    Bodies bodies_of(std::uint32_t island) const {
        Bodies found;
        for (std::uint32_t b = state.islands.islands[island].first; b != none;
             b = state.bodies.cold[b].island_next)
            found.push_back(b);
        return found;
    }
    // As if the two touched.
    std::uint32_t touch(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t contact = create_contact(state, a, b);  // a box's shape has its index
        begin_touch(state, state.joints, contact);
        return contact;
    }
    std::string fault() const { return find_fault(state).value_or(""); }
};

TEST(Islands, smaller_island_merges_into_larger_and_ties_go_to_the_lower_index) {
    Row row(4);
    join_islands(row.state, row.state.joints, 3, 1);
    EXPECT_EQ(row.bodies_of(1), (Bodies{1, 3}));
    EXPECT_FALSE(row.state.islands.ids.alive(3));
    join_islands(row.state, row.state.joints, 0, 1);
    EXPECT_EQ(row.bodies_of(1), (Bodies{1, 3, 0}));
    EXPECT_EQ(row.island(1).bodies, 3u);
    EXPECT_NEAR(row.island(1).mass, 3000, 1e-9);
    EXPECT_FALSE(row.state.islands.ids.alive(0));
    join_islands(row.state, row.state.joints, 1, 1);
    EXPECT_EQ(row.island(1).bodies, 3u) << "with itself it stays what it is";
    EXPECT_EQ(row.fault(), "");
}

TEST(Islands, merged_island_has_the_flags_of_both) {
    Row row(2);
    row.island(0).split_at = 70;
    row.island(0).remaining_load = 0.5;
    row.island(1).may_be_split = row.island(1).uneven = true;
    row.island(1).split_at = 30;
    join_islands(row.state, row.state.joints, 0, 1);
    EXPECT_TRUE(row.island(0).may_be_split);
    EXPECT_TRUE(row.island(0).uneven);
    EXPECT_EQ(row.island(0).split_at, 70u);
    EXPECT_EQ(row.island(0).remaining_load, 0.5);
}

TEST(Islands, bodies_can_be_removed_in_any_order_and_the_last_frees_the_island) {
    Row row(3);
    join_islands(row.state, row.state.joints, 0, 1);
    join_islands(row.state, row.state.joints, 0, 2);
    remove_from_island(row.state, 1);
    EXPECT_EQ(row.bodies_of(0), (Bodies{0, 2}));
    EXPECT_NEAR(row.island(0).mass, 2000, 1e-9);
    remove_from_island(row.state, 0);
    EXPECT_EQ(row.bodies_of(0), Bodies{2});
    EXPECT_EQ(row.island(0).last, 2u);
    remove_from_island(row.state, 2);
    EXPECT_FALSE(row.state.islands.ids.alive(0));
    EXPECT_EQ(create_island(row.state.islands, row.state.def), 0u) << "the lowest that is free";
    for (const std::uint32_t body : {2u, 0u, 1u}) add_to_island(row.state, 0, body);
    EXPECT_EQ(row.bodies_of(0), (Bodies{2, 0, 1}));
    EXPECT_EQ(row.fault(), "");
}

// Five boxes in touch one after the other; the touch in the middle ends.
TEST(Islands, are_split_where_contacts_ended) {
    Row row(5);
    std::vector<std::uint32_t> contacts;
    for (std::uint32_t k = 0; k + 1 < 5; k++) contacts.push_back(row.touch(k, k + 1));
    ASSERT_EQ(row.island(0).bodies, 5u);
    row.state.steps = 42;
    end_touch(row.state, contacts[1]);
    row.island(0).calm = 3;
    split_island(row.state, 0);
    EXPECT_EQ(row.bodies_of(0), (Bodies{0, 1})) << "what is with its first body keeps the index";
    EXPECT_EQ(row.bodies_of(1), (Bodies{2, 3, 4}));
    EXPECT_NEAR(row.island(1).mass, 3000, 1e-9);
    for (const std::uint32_t part : {0u, 1u}) {
        EXPECT_FALSE(row.island(part).may_be_split);
        EXPECT_EQ(row.island(part).split_at, 42u);
        EXPECT_EQ(row.island(part).calm, 3) << "each is what the whole was";
    }
    EXPECT_EQ(row.fault(), "");
}

TEST(Islands, joints_keep_islands_together_without_contacts) {
    Row row(3);
    const auto joint = must(row.world.create_joint(
        {.body_a = body_id(row.state.bodies, 0), .body_b = body_id(row.state.bodies, 2)}));
    end_touch(row.state, row.touch(0, 1));
    split_island(row.state, row.island_of(0));
    EXPECT_EQ(row.island_of(0), row.island_of(2));
    EXPECT_NE(row.island_of(0), row.island_of(1));
    must(row.world.destroy_joint(joint));
    split_island(row.state, row.island_of(0));
    EXPECT_NE(row.island_of(0), row.island_of(2));
    EXPECT_EQ(row.fault(), "");
}

}  // namespace
}  // namespace jostle::test
