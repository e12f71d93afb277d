// SPDX-License-Identifier: MIT
#include "jostle/base/nearest_name.h"

#include <gtest/gtest.h>

namespace jostle {
namespace {

const std::vector<std::string> scenes = {"sandbox", "pyramid", "stack", "race_track"};

TEST(NearestName, counts_edits_and_swapped_neighbours_as_one) {
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("sandbox", "sandbx"), 1u);
    EXPECT_EQ(edit_distance("postion", "position"), 1u);
    EXPECT_EQ(edit_distance("wrold", "world"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestName, suggests_a_name_that_differs_in_a_third_of_its_characters) {
    EXPECT_EQ(nearest_name("sandbx", scenes), "sandbox");
    EXPECT_EQ(nearest_name("racetrac", scenes), "race_track");
    EXPECT_EQ(nearest_name("stakc", scenes), "stack");
    EXPECT_EQ(nearest_name("dominoes", scenes), "");
    EXPECT_EQ(nearest_name("", scenes), "");
    EXPECT_EQ(did_you_mean("pyramids", scenes), "; did you mean \"pyramid\"?");
    EXPECT_EQ(did_you_mean("x", scenes), "");
}

TEST(NearestName, suggests_nothing_for_a_text_longer_than_any_name) {
    EXPECT_EQ(nearest_name(std::string(65, 'a'), std::vector<std::string>{std::string(64, 'a')}),
              "");
}

}  // namespace
}  // namespace jostle
