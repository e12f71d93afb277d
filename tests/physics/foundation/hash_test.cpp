// SPDX-License-Identifier: MIT
//
// The same words in the same order give the same hash on every machine, any other words another.
#include "physics/src/foundation/hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace jostle::test {
namespace {
using physics::Hasher;

std::uint64_t hash_of(std::initializer_list<std::uint64_t> words) {
    Hasher hasher;
    for (const std::uint64_t word : words) hasher.add(word);
    return hasher.value;
}

// Saved worlds hold such a hash: another one would make them unreadable.
TEST(Hasher, matches_reference_values) {
    EXPECT_EQ(hash_of({}), 0x9e3779b97f4a7c15ull);
    EXPECT_EQ(hash_of({0}), 0x3ad7e0ab23f5aaffull);
    EXPECT_EQ(hash_of({1, 2, 3}), 0x11e800314e9665e6ull);
}

TEST(Hasher, depends_on_order_and_length) {
    EXPECT_NE(hash_of({1, 2}), hash_of({2, 1}));
    EXPECT_NE(hash_of({1}), hash_of({1, 0}));
    EXPECT_NE(hash_of({0}), hash_of({0, 0}));
}

// Each of the 64 bits of a word changes about half of the hash's: 16 to 48 of them here.
TEST(Hasher, depends_on_every_bit) {
    const std::uint64_t plain = hash_of({0x0123456789abcdef});
    for (int bit = 0; bit < 64; bit++) {
        const std::uint64_t other = hash_of({0x0123456789abcdef ^ (1ull << bit)});
        const int changed = std::popcount(plain ^ other);
        EXPECT_GE(changed, 16) << "bit " << bit;
        EXPECT_LE(changed, 48) << "bit " << bit;
    }
}

TEST(Hasher, a_hundred_thousand_numbers_do_not_collide) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t k = 0; k < 100000; k++) seen.insert(hash_of({k}));
    EXPECT_EQ(seen.size(), 100000u);
}

}  // namespace
}  // namespace jostle::test
