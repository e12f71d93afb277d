// SPDX-License-Identifier: MIT
//
// Flags and rows of one lane do not touch another.
#include "physics/src/constraint_graph/contact_constraint_wide.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

TEST(LaneFlag, sets_one_bit_of_one_lane) {
    ContactConstraintWideMeta meta{};
    meta.set(LaneFlag::rolls, 3, true);
    meta.set(LaneFlag::rolls, 7, true);
    EXPECT_EQ(meta.bits(LaneFlag::rolls), 0b10001000);
    EXPECT_EQ(meta.bits(LaneFlag::bounces), 0);
    meta.set(LaneFlag::rolls, 3, false);
    EXPECT_FALSE(meta.has(LaneFlag::rolls, 3));
    EXPECT_TRUE(meta.has(LaneFlag::rolls, 7));
}

// What is saved of a lane are rows of floats: they must be the fields that they stand for.
TEST(ContactConstraintWide, rows_match_the_field_order) {
    ContactConstraintWide block{};
    put_lane(block.normal, 5, {0.25, -0.5, 0.75});
    block.anchor_blend[5] = 0.125f;
    EXPECT_EQ(float_at(block, first_saved_row, 5), 0.25f);
    EXPECT_EQ(float_at(block, first_saved_row + 2, 5), 0.75f);
    EXPECT_EQ(float_at(block, wide_rows - 1, 5), 0.125f);
    EXPECT_EQ(float_at(block, first_saved_row, 4), 0);
    EXPECT_EQ(get_lane(block.normal, 5), (Vec3{0.25, -0.5, 0.75}));
    RollingWide rolling{};
    rolling.roll[1][2] = 3;
    EXPECT_EQ(float_at(rolling, rolling_rows - 1, 2), 3);
}

TEST(ContactConstraintWide, has_one_point_if_the_second_gap_is_unused) {
    EXPECT_TRUE(is_single_point(no_point));
    EXPECT_FALSE(is_single_point(0.02f));
    SavedContact saved;
    constexpr int second_gap = offsetof(ContactConstraintWide, gap) / 32 + 1 - first_saved_row;
    saved.rows[second_gap] = no_point;
    EXPECT_TRUE(is_single_point(saved));
    saved.rows[second_gap] = -0.001f;
    EXPECT_FALSE(is_single_point(saved));
}

}  // namespace
}  // namespace jostle::test
