// SPDX-License-Identifier: MIT
//
// Sub-steps of each tier, and a colour set for each tier and batch.
#include "physics/src/constraint_graph/solver_tier.h"

#include <gtest/gtest.h>

#include <set>

namespace jostle::test {
namespace {
using namespace physics;

TEST(SolverTier, eight_substeps_yield_four_to_thirty_two_by_tier) {
    const WorldDef world{.substeps = 8};
    const int expected[] = {4, 8, 12, 8, 16, 32, 4};
    for (const SolverTier tier : all_tiers)
        EXPECT_EQ(substeps_of(tier, world), expected[index_of(tier)]) << index_of(tier);
}

TEST(SolverTier, piles_take_more_substeps_only_if_sleeping_is_enabled) {
    EXPECT_EQ(substeps_of(SolverTier::pile, {.substeps = 8, .sleeping = false}), 8);
    EXPECT_EQ(substeps_of(SolverTier::pile, {.substeps = 5, .sleeping = true}), 8) << "rounded up";
}

TEST(SolverTier, tolerance_level_sets_the_substeps_up_to_64) {
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

TEST(SolverTier, halving_keeps_two_substeps_and_skips_tall_tiers) {
    const int expected[] = {2, 4, 6, 8, 16, 32, 4};
    for (const SolverTier tier : all_tiers)
        EXPECT_EQ(substeps_of({tier, 0}, {.substeps = 8}, true), expected[index_of(tier)]);
    EXPECT_EQ(substeps_of({SolverTier::low, 0}, {.substeps = 3}, true), 2);
    EXPECT_EQ(substeps_of({SolverTier::flat, 0}, {.substeps = 2}, true), 1) << "as before";
}

TEST(SolverTier, size_levels_multiply_the_sub_steps_up_to_a_bound) {
    const int low[] = {8, 24, 64, 192}, heavy[] = {32, 96, 256, 256};
    for (std::uint8_t level = 0; level < batch_count; level++) {
        EXPECT_EQ(substeps_of({SolverTier::low, level}, WorldDef{}, false, true), low[level]);
        EXPECT_EQ(substeps_of({SolverTier::heavy, level}, WorldDef{}, false, true), heavy[level]);
    }
    EXPECT_EQ(substeps_of({SolverTier::heavy, 0}, {.substeps = 64}, false, true), 256);
}

TEST(SolverTier, always_takes_at_least_one_substep) {
    EXPECT_EQ(substeps_of(SolverTier::flat, {.substeps = 1}), 1);
}

TEST(SolverTier, low_to_slender_tiers_are_not_changed_by_neighbours) {
    std::set<SolverTier> usual;
    for (const SolverTier tier : all_tiers)
        if (is_usual(tier)) usual.insert(tier);
    EXPECT_EQ(usual, (std::set{SolverTier::low, SolverTier::pile, SolverTier::slender}));
}

TEST(ColourSetKey, every_tier_and_batch_has_a_set_and_sleeping_uses_the_last) {
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
