// SPDX-License-Identifier: MIT
//
// Delta encoding of word lists: round trips and inconsistent bytes.
#include "jostle/snapshot/word_changes.h"

#include <gtest/gtest.h>

#include <random>

namespace jostle::snapshot {
namespace {

using Words = std::vector<std::uint32_t>;

TEST(WordChanges, contain_only_changed_words) {
    const Words before{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, now{1, 2, 0xfffefdfc, 4, 5, 6, 7, 8, 0, 10};
    const WordChanges changes = changes_between(before, now);
    EXPECT_EQ(changes.changed, std::string("\x04\x01", 2)) << "words 2 and 8";
    EXPECT_EQ(changes.values, std::string("\xfc\xfd\xfe\xff\0\0\0\0", 8));
    EXPECT_EQ(*apply_changes(before, 10, changes.changed, changes.values), now);
    EXPECT_EQ(changes_between(now, now).changed, "");
}

TEST(WordChanges, round_trip_any_pair_of_lists) {
    std::mt19937 random(3);
    for (int k = 0; k < 2000; k++) {
        Words before(random() % 40), now(random() % 40);
        for (std::uint32_t& word : before) word = static_cast<std::uint32_t>(random() % 3);
        for (std::uint32_t& word : now) word = static_cast<std::uint32_t>(random() % 3);
        const WordChanges changes = changes_between(before, now);
        const auto again = apply_changes(before, now.size(), changes.changed, changes.values);
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(*again, now);
    }
}

TEST(WordChanges, reject_inconsistent_data) {
    const Words before{1, 2, 3};
    for (const auto& [changed, values] : {std::pair<std::string, std::string>{"\x01", ""},
                                          {"\x01", "12345678"},
                                          {"", "1234"},
                                          {"\x08", "1234"},
                                          {std::string("\0\x01", 2), "1234"}}) {
        const auto words = apply_changes(before, 3, changed, values);
        ASSERT_FALSE(words.ok());
        EXPECT_EQ(words.error().code, ErrorCode::corrupt_data);
        EXPECT_NE(words.error().message.find("controlled entity state"), std::string::npos);
    }
    EXPECT_FALSE(apply_changes(before, words_max + 1, "", "").ok())
        << "must not allocate an oversized list";
}

}  // namespace
}  // namespace jostle::snapshot
