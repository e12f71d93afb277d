// SPDX-License-Identifier: MIT
//
// A set that holds what was put in and not taken out, whatever the order.
#include "physics/src/foundation/key_set.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using physics::KeySet;

// Two small numbers side by side, as pairs of shapes are.
std::uint64_t pair_of(std::uint64_t low, std::uint64_t high) {
    return low << 32 | high;
}

TEST(KeySet, is_initially_empty) {
    KeySet keys;
    EXPECT_EQ(keys.size(), 0u);
    EXPECT_FALSE(keys.contains(0));
    keys.erase(0);
    EXPECT_EQ(keys.size(), 0u);
}

TEST(KeySet, contains_a_key_once) {
    KeySet keys;
    keys.insert(pair_of(3, 7));
    keys.insert(pair_of(3, 7));
    EXPECT_EQ(keys.size(), 1u);
    EXPECT_TRUE(keys.contains(pair_of(3, 7)));
    EXPECT_FALSE(keys.contains(pair_of(7, 3)));
    keys.erase(pair_of(3, 7));
    EXPECT_FALSE(keys.contains(pair_of(3, 7)));
}

// 40,000 neighbours of a grid go in, every third goes out again.
TEST(KeySet, distinguishes_forty_thousand_present_and_removed_pairs) {
    KeySet keys;
    for (std::uint64_t i = 0; i < 10000; i++)
        for (std::uint64_t k = 1; k <= 4; k++) keys.insert(pair_of(i, i + k));
    for (std::uint64_t i = 0; i < 10000; i += 3)
        for (std::uint64_t k = 1; k <= 4; k++) keys.erase(pair_of(i, i + k));
    EXPECT_EQ(keys.size(), 4u * 6666);
    for (std::uint64_t i = 0; i < 10000; i++) {
        for (std::uint64_t k = 1; k <= 4; k++)
            ASSERT_EQ(keys.contains(pair_of(i, i + k)), i % 3 != 0) << i << ", " << k;
        ASSERT_FALSE(keys.contains(pair_of(i, i + 5)));
    }
}

// 200,000 calls over 600 keys: chains form, break and wrap around the end of the array.
TEST(KeySet, matches_a_reference_set) {
    KeySet keys;
    std::set<std::uint64_t> known;
    Random random(8);
    for (int call = 0; call < 200000; call++) {
        const auto key = pair_of(static_cast<std::uint64_t>(random.in(0, 20)),
                                 static_cast<std::uint64_t>(random.in(0, 30)));
        if (random.in(0, 1) < 0.5) {
            keys.insert(key);
            known.insert(key);
        } else {
            keys.erase(key);
            known.erase(key);
        }
        const auto asked = pair_of(static_cast<std::uint64_t>(random.in(0, 20)), 7);
        ASSERT_EQ(keys.contains(asked), known.contains(asked)) << "call " << call;
        ASSERT_EQ(keys.size(), known.size()) << "call " << call;
    }
    for (const std::uint64_t key : known) ASSERT_TRUE(keys.contains(key));
}

}  // namespace
}  // namespace jostle::test
