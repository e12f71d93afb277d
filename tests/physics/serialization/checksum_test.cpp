// SPDX-License-Identifier: MIT
//
// Saved worlds outlive programs: their checksums are the same for ever.
#include "physics/src/serialization/checksum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace jostle::test {
namespace {
using namespace physics;

std::vector<std::byte> counting(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t k = 0; k < size; k++) bytes[k] = static_cast<std::byte>(k * 7 + 1);
    return bytes;
}

TEST(Checksum, matches_reference_values) {
    EXPECT_EQ(checksum_of_version(16, counting(77)), 9387607372426538556u);
    EXPECT_EQ(checksum_of_version(17, counting(77)), 752059171743658286u);
    EXPECT_EQ(checksum_of_version(17, counting(64)), 701218710009930888u);
    EXPECT_EQ(checksum_of_version(17, {}), 393797542852586972u);
}

TEST(Checksum, detects_each_bit_flip_truncation_and_swapped_words) {
    for (const std::size_t size : {1u, 8u, 31u, 32u, 64u, 77u}) {
        const std::vector<std::byte> bytes = counting(size);
        const std::uint64_t sum = checksum(bytes);
        for (std::size_t k = 0; k < 8 * size; k++) {
            std::vector<std::byte> other = bytes;
            other[k / 8] ^= static_cast<std::byte>(1u << k % 8);
            EXPECT_NE(checksum(other), sum) << "bit " << k << " of " << size << " bytes";
        }
        std::vector<std::byte> longer = bytes;
        longer.push_back(std::byte{0});
        EXPECT_NE(checksum(longer), sum) << "a zero after " << size << " bytes";
    }
    const std::vector<std::byte> bytes = counting(96);
    for (std::size_t from = 0; from < 96; from += 8)
        for (std::size_t to = 0; to < from; to += 8) {
            std::vector<std::byte> other = bytes;
            std::swap_ranges(other.begin() + static_cast<std::ptrdiff_t>(from),
                             other.begin() + static_cast<std::ptrdiff_t>(from + 8),
                             other.begin() + static_cast<std::ptrdiff_t>(to));
            EXPECT_NE(checksum(other), checksum(bytes)) << from << " and " << to;
        }
}

}  // namespace
}  // namespace jostle::test
