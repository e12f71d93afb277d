// SPDX-License-Identifier: MIT
//
// Contacts come to a colour, leave it and take all that is in their lanes along.
#include "physics/src/constraint_graph/constraint_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace jostle::test {
namespace {
using namespace physics;

constexpr ColourSetKey low{SolverTier::low, 0};

// A graph with contacts 100, 101, ... in one colour.
std::unique_ptr<ConstraintGraph> graph_with(int contacts, int colour) {
    auto graph = std::make_unique<ConstraintGraph>();
    for (int k = 0; k < contacts; k++)
        add_contact(*graph, low, colour, 100 + static_cast<std::uint32_t>(k));
    return graph;
}
GraphColour& colour_of(ConstraintGraph& graph, int colour) {
    return graph.sets[index_of(low)].colours[static_cast<std::size_t>(colour)];
}
std::uint32_t owner(ConstraintGraph& graph, int colour, std::int32_t slot) {
    const ContactLaneRef place = lane_ref_at(graph, low, colour, slot);
    return place.meta->contact[place.lane];
}

TEST(FreeColour, is_the_lowest_unused_colour) {
    EXPECT_EQ(free_colour(0, PairKind::dynamic), 0);
    EXPECT_EQ(free_colour(0b1011, PairKind::dynamic), 2);
    EXPECT_EQ(free_colour(0, PairKind::kinematic), dynamic_colours);
    EXPECT_EQ(free_colour(0, PairKind::static_), dynamic_colours + kinematic_colours);
}

// A body may have 48 contacts with others of its kind; the next is solved on its own.
TEST(FreeColour, overflows_if_all_colours_of_the_kind_are_used) {
    std::uint64_t taken = 0;
    for (int k = 0; k < dynamic_colours; k++) {
        const int colour = free_colour(taken, PairKind::dynamic);
        EXPECT_EQ(colour, k);
        EXPECT_EQ(pair_kind_of(colour), PairKind::dynamic);
        taken |= 1ull << colour;
    }
    const int overflow = free_colour(taken, PairKind::dynamic);
    EXPECT_TRUE(is_overflow(overflow));
    EXPECT_EQ(pair_kind_of(overflow), PairKind::dynamic);
    EXPECT_EQ(lanes_per_block(overflow), 1);
    EXPECT_FALSE(is_overflow(free_colour(taken, PairKind::kinematic))) << "others have theirs";
    EXPECT_EQ(pair_kind_of(free_colour(~0ull, PairKind::static_)), PairKind::static_);
}

TEST(SolveOrder, contains_every_list_once_and_static_lists_last) {
    std::vector<int> seen(solve_order.begin(), solve_order.end());
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end(),
                               [](int a, int b) { return pair_kind_of(a) < pair_kind_of(b); }));
    std::sort(seen.begin(), seen.end());
    for (int c = 0; c < colour_count; c++) EXPECT_EQ(seen[static_cast<std::size_t>(c)], c);
}

TEST(AsleepColour, spreads_contacts_over_all_colours_of_their_kind) {
    std::vector<int> contacts(mask_colours, 0);
    for (std::uint32_t contact = 0; contact < 480; contact++) {
        const int colour = asleep_colour(PairKind::dynamic, contact);
        ASSERT_EQ(pair_kind_of(colour), PairKind::dynamic);
        contacts[static_cast<std::size_t>(colour)]++;
    }
    for (int c = 0; c < dynamic_colours; c++) EXPECT_EQ(contacts[static_cast<std::size_t>(c)], 10);
}

TEST(ConstraintGraph, eight_contacts_share_a_block_except_in_overflow_lists) {
    const auto graph = graph_with(9, 3);
    EXPECT_EQ(colour_of(*graph, 3).contacts, 9);
    EXPECT_EQ(colour_of(*graph, 3).blocks.size(), 2u);
    EXPECT_EQ(lane_ref_at(*graph, low, 3, 8).lane, 0);
    EXPECT_EQ(lane_ref_at(*graph, low, 3, 7).block, &colour_of(*graph, 3).blocks[0]);
    const auto alone = graph_with(9, overflow_colours);
    EXPECT_EQ(colour_of(*alone, overflow_colours).blocks.size(), 9u);
    EXPECT_EQ(graph->sets[index_of(low)].contacts, 9);
}

// An empty lane solves to nothing: no body, no impulse, gaps that are far, and nothing to divide by
// that is zero.
TEST(ConstraintGraph, new_lane_holds_only_its_contact_index) {
    const auto graph = graph_with(1, 0);
    const ContactLaneRef place = lane_ref_at(*graph, low, 0, 0);
    EXPECT_EQ(place.meta->contact[0], 100u);
    EXPECT_EQ(place.meta->contact[1], no_contact);
    for (int lane = 0; lane < block_lanes; lane++) {
        EXPECT_EQ(place.block->a[lane], 0);
        for (const auto& gap : place.block->gap) EXPECT_EQ(gap[lane], no_point);
        for (const auto& lambda : place.block->lambda) EXPECT_EQ(lambda[lane], 0);
        EXPECT_EQ(place.block->g[0][lane], 1);
    }
    for (const std::uint8_t flags : place.meta->flags) EXPECT_EQ(flags, 0);
}

TEST(ConstraintGraph, removal_moves_the_last_contact_and_returns_it) {
    const auto graph = graph_with(10, 5);
    EXPECT_EQ(remove_contact(*graph, low, 5, 2), 109u);
    EXPECT_EQ(owner(*graph, 5, 2), 109u);
    EXPECT_EQ(colour_of(*graph, 5).contacts, 9);
    EXPECT_EQ(graph->sets[index_of(low)].contacts, 9);
    EXPECT_EQ(remove_contact(*graph, low, 5, 8), no_contact) << "it was the last one";
    EXPECT_EQ(colour_of(*graph, 5).blocks.size(), 1u);
    EXPECT_EQ(owner(*graph, 5, 7), 107u);
    for (int left = 8; left > 0; left--) remove_contact(*graph, low, 5, 0);
    EXPECT_EQ(colour_of(*graph, 5).blocks.size(), 0u);
    EXPECT_EQ(graph->sets[index_of(low)].contacts, 0);
}

TEST(ConstraintGraph, moving_a_lane_moves_all_its_data) {
    const auto graph = graph_with(12, 1);
    const ContactLaneRef last = lane_ref_at(*graph, low, 1, 11);
    last.block->a[last.lane] = 7;
    for (int row = first_saved_row; row < wide_rows; row++)
        float_at(*last.block, row, last.lane) = static_cast<float>(row);
    for (int row = 0; row < rolling_rows; row++)
        float_at(*last.rolling, row, last.lane) = static_cast<float>(-row);
    last.meta->moved[last.lane] = 0.25f;
    last.meta->restitution[last.lane] = 0.5f;
    for (std::size_t k = 0; k < lane_flag_count; k += 2)
        last.meta->set(static_cast<LaneFlag>(k), last.lane, true);
    const ContactLaneRef hole = lane_ref_at(*graph, low, 1, 4);
    for (std::size_t k = 1; k < lane_flag_count; k += 2)
        hole.meta->set(static_cast<LaneFlag>(k), hole.lane, true);

    ASSERT_EQ(remove_contact(*graph, low, 1, 4), 111u);
    EXPECT_EQ(hole.block->a[hole.lane], 7);
    for (int row = first_saved_row; row < wide_rows; row++)
        EXPECT_EQ(float_at(*hole.block, row, hole.lane), static_cast<float>(row));
    for (int row = 0; row < rolling_rows; row++)
        EXPECT_EQ(float_at(*hole.rolling, row, hole.lane), static_cast<float>(-row));
    EXPECT_EQ(hole.meta->moved[hole.lane], 0.25f);
    EXPECT_EQ(hole.meta->restitution[hole.lane], 0.5f);
    for (std::size_t k = 0; k < lane_flag_count; k++) {
        const auto flag = static_cast<LaneFlag>(k);
        EXPECT_EQ(hole.meta->has(flag, hole.lane), k % 2 == 0) << "flag " << k;
        EXPECT_FALSE(hole.meta->has(flag, hole.lane + 1)) << "of its neighbour";
    }
    // Where it was nothing is left.
    const GraphColour& colour = colour_of(*graph, 1);
    EXPECT_EQ(colour.metas[1].contact[3], no_contact);
    for (const std::uint8_t flags : colour.metas[1].flags) EXPECT_EQ(flags, 0);
    EXPECT_EQ(colour.blocks[1].mu[3], 0);
}

TEST(ConstraintGraph, saved_contact_is_restored_in_another_colour_with_derived_flags_unchanged) {
    const auto graph = graph_with(3, 2);
    const ContactLaneRef place = lane_ref_at(*graph, low, 2, 1);
    for (int row = first_saved_row; row < wide_rows; row++)
        float_at(*place.block, row, place.lane) = 0.5f * static_cast<float>(row);
    place.rolling->rolling[place.lane] = 0.125f;
    place.meta->moved[place.lane] = 0.001f;
    place.meta->restitution[place.lane] = 0.75f;
    for (const LaneFlag flag : {LaneFlag::needs_rebuild, LaneFlag::rolls, LaneFlag::anisotropic})
        place.meta->set(flag, place.lane, true);
    const SavedContact saved = save_contact(place);
    EXPECT_EQ(saved.contact, 101u);
    remove_contact(*graph, low, 2, 1);

    add_contact(*graph, low, 20, 999);
    const std::int32_t slot = add_contact(*graph, low, 20, 101);
    const ContactLaneRef there = lane_ref_at(*graph, low, 20, slot);
    restore_contact(there, saved);
    for (int row = first_saved_row; row < wide_rows; row++)
        EXPECT_EQ(float_at(*there.block, row, there.lane), 0.5f * static_cast<float>(row));
    EXPECT_EQ(there.rolling->rolling[there.lane], 0.125f);
    EXPECT_EQ(there.meta->moved[there.lane], 0.001f);
    EXPECT_TRUE(there.meta->has(LaneFlag::needs_rebuild, there.lane));
    EXPECT_TRUE(there.meta->has(LaneFlag::rolls, there.lane));
    EXPECT_TRUE(there.meta->has(LaneFlag::bounces, there.lane)) << "by its restitution";
    EXPECT_FALSE(there.meta->has(LaneFlag::anisotropic, there.lane)) << "follows from the bodies";
    EXPECT_FALSE(there.meta->has(LaneFlag::rolls, 0)) << "of its neighbour";
}

// 1600 contacts take 200 blocks; when all but eight are gone so is most of the memory.
TEST(ConstraintGraph, frees_memory_after_most_contacts_are_removed) {
    const auto graph = graph_with(1600, 0);
    for (int left = 1600; left > 8; left--) remove_contact(*graph, low, 0, 0);
    EXPECT_EQ(colour_of(*graph, 0).blocks.size(), 1u);
    EXPECT_LE(colour_of(*graph, 0).blocks.capacity(), 8u);
    EXPECT_LE(colour_of(*graph, 0).metas.capacity(), 8u);
}

TEST(ConstraintGraph, sorts_contacts_by_body) {
    const auto graph = graph_with(40, 0);
    GraphColour& colour = colour_of(*graph, 0);
    for (std::int32_t slot = 0; slot < 40; slot++) {
        const ContactLaneRef place = lane_ref_at(colour, 0, slot);
        place.block->a[place.lane] = 1 + slot * 7 % 40;
        place.block->b[place.lane] = -1;  // is not pushed: a alone counts
    }
    EXPECT_FALSE(is_sorted(colour));
    sort_contacts(colour, 0);
    EXPECT_TRUE(is_sorted(colour));
    for (std::int32_t slot = 0; slot < 40; slot++) {
        const ContactLaneRef place = lane_ref_at(colour, 0, slot);
        EXPECT_EQ(place.block->a[place.lane], 1 + slot);
        EXPECT_EQ((place.meta->contact[place.lane] - 100) * 7 % 40, static_cast<unsigned>(slot));
    }
}

TEST(ConstraintGraph, sets_of_two_thousand_contacts_are_multithreaded) {
    ColourSet set;
    set.contacts = 1999;
    EXPECT_FALSE(is_shared(set));
    set.contacts = 2000;
    EXPECT_TRUE(is_shared(set));
}

TEST(ConstraintGraph, iteration_visits_every_colour_of_non_empty_sets) {
    const auto graph = graph_with(1, 7);
    add_contact(*graph, asleep_set, 9, 200);
    int met = 0, contacts = 0;
    for_each_colour(graph->sets, [&](const GraphColour& colour, int number) {
        met++;
        contacts += colour.contacts * number;
    });
    EXPECT_EQ(met, 2 * colour_count);
    EXPECT_EQ(contacts, 7 + 9);
    met = 0;
    for_each_colour(graph->solved(), [&](const GraphColour&) { met++; });
    EXPECT_EQ(met, colour_count) << "what sleeps in place is not solved";
}

}  // namespace
}  // namespace jostle::test
