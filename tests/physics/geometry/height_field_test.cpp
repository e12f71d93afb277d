// SPDX-License-Identifier: MIT
//
// Heights to a field: its bounds, its holes, and what is refused.
#include "jostle/physics/height_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(HeightField, errors_name_the_problem) {
    EXPECT_FALSE(build_height_field({.columns = 2, .rows = 2, .heights = {0, 0, 0}}).ok());
    EXPECT_FALSE(build_height_field({.columns = 1, .rows = 2, .heights = {0, 0}}).ok());
    EXPECT_FALSE(
        build_height_field({.columns = 2, .rows = 2, .spacing_x = -1, .heights = {0, 0, 0, 0}})
            .ok());
    EXPECT_FALSE(
        build_height_field({.columns = 0xffffffff, .rows = 0xffffffff, .heights = {}}).ok());
    const auto wrong = build_height_field({.columns = 3, .rows = 2, .heights = {0, 0, 0, 0}});
    EXPECT_EQ(wrong.error().message, "height field: it has 4 heights; 3 x 2 samples need 6");
}

// 3 x 2 samples 2 m and 5 m apart stand about the origin.
TEST(HeightField, bounds_span_the_lowest_to_the_highest_sample_around_the_origin) {
    const auto field = must(build_height_field(
        {.columns = 3, .rows = 2, .spacing_x = 2, .spacing_z = 5, .heights = {0, 1, 7, -3, 0, 2}}));
    EXPECT_EQ(field->bounds, (Aabb{{-2, -3, -2.5}, {2, 7, 2.5}}));
    EXPECT_TRUE(field->holes.empty());
}

// A sample that is no number in the middle of 3 x 3 takes all four cells away, one in a corner one.
TEST(HeightField, missing_height_makes_holes_of_adjacent_cells) {
    const double none = std::nan("");
    const auto holes = [](std::uint32_t rows, std::vector<double> heights) {
        return must(build_height_field({.columns = 3, .rows = rows, .heights = std::move(heights)}))
            ->holes;
    };
    EXPECT_EQ(holes(2, {0, 0, none, 0, 0, 0}), (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(holes(3, {1, 1, 1, 1, none, 1, 1, 1, 1}), (std::vector<std::uint8_t>{1, 1, 1, 1}));
    EXPECT_EQ(holes(3, {none, 1, 1, 1, 1, 1, 1, 1, 1}), (std::vector<std::uint8_t>{1, 0, 0, 0}));
}

}  // namespace
}  // namespace jostle::test
