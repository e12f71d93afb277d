// SPDX-License-Identifier: MIT
//
// Sub-steps of each tier, and a colour set for each tier and batch.
#include "physics/src/constraint_graph/solver_tier.h"

#include <gtest/gtest.h>

#include <set>

namespace jostle::test {
namespace {
using namespace physics;

TEST(SolverTier, of_eight_substeps_takes_four_to_thirty_two) {
    const WorldDef world{.substeps = 8};
    const int expected[] = {4, 8, 12, 8, 16, 32};
    for (const SolverTier tier : all_tiers)
        EXPECT_EQ(substeps_of(tier, world), expected[index_of(tier)]) << index_of(tier);
}

TEST(SolverTier, heaps_take_more_only_where_bodies_may_sleep) {
    EXPECT_EQ(substeps_of(SolverTier::pile, {.substeps = 8, .sleeping = false}), 8);
    EXPECT_EQ(substeps_of(SolverTier::pile, {.substeps = 5, .sleeping = true}), 8) << "rounded up";
}

TEST(SolverTier, with_a_tolerance_a_rung_says_how_many_and_never_more_than_64) {
    const WorldDef world{.tolerance = 0.01};
    const int low[] = {2, 6, 16, 48}, slender[] = {6, 18, 48, 64}, tall[] = {16, 48, 64, 64},
              heavy[] = {8, 24, 64, 64};
    for (std::uint8_t substep_level = 0; substep_level < batch_count; substep_level++) {
        EXPECT_EQ(substeps_of({SolverTier::low, substep_level}, world), low[substep_level]);
        EXPECT_EQ(substeps_of({SolverTier::slender, substep_level}, world), slender[substep_level]);
        EXPECT_EQ(substeps_of({SolverTier::tall, substep_level}, world), tall[substep_level]);
        EXPECT_EQ(substeps_of({SolverTier::heavy, substep_level}, world), heavy[substep_level]);
        EXPECT_EQ(substeps_of({SolverTier::low, substep_level}, WorldDef{}), 8) << "without one";
    }
}

TEST(SolverTier, halved_leaves_two_and_spares_what_would_fall) {
    const int expected[] = {2, 4, 6, 8, 16, 32};
    for (const SolverTier tier : all_tiers)
        EXPECT_EQ(substeps_of({tier, 0}, {.substeps = 8}, true), expected[index_of(tier)]);
    EXPECT_EQ(substeps_of({SolverTier::low, 0}, {.substeps = 3}, true), 2);
    EXPECT_EQ(substeps_of({SolverTier::flat, 0}, {.substeps = 2}, true), 1) << "as before";
}

TEST(SolverTier, never_takes_none) {
    EXPECT_EQ(substeps_of(SolverTier::flat, {.substeps = 1}), 1);
}

TEST(SolverTier, from_low_to_slender_neighbours_change_nothing) {
    std::set<SolverTier> usual;
    for (const SolverTier tier : all_tiers)
        if (is_usual(tier)) usual.insert(tier);
    EXPECT_EQ(usual, (std::set{SolverTier::low, SolverTier::pile, SolverTier::slender}));
}

TEST(ColourSetKey, every_tier_and_batch_has_a_set_and_what_sleeps_the_last) {
    std::set<std::size_t> sets;
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++)
            sets.insert(index_of(ColourSetKey{tier, batch}));
    EXPECT_EQ(sets.size(), static_cast<std::size_t>(solved_set_count));
    EXPECT_EQ(*sets.rbegin(), static_cast<std::size_t>(solved_set_count - 1));
    EXPECT_EQ(index_of(asleep_set), static_cast<std::size_t>(solved_set_count));
}

}  // namespace
}  // namespace jostle::test
