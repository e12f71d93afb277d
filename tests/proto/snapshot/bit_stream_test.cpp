// SPDX-License-Identifier: MIT
#include "jostle/snapshot/bit_stream.h"

#include <gtest/gtest.h>

#include "jostle/snapshot/crc32.h"

namespace jostle::snapshot {

TEST(BitStream, round_trips_every_code) {
    BitWriter out;
    const std::uint64_t values[] = {0, 1, 2, 14, 15, 16, 100, 65535, 1u << 20, 0xffffffffull};
    for (const std::uint64_t v : values)
        for (unsigned k = 0; k < 9; k++) {
            out.rice(v, k);
            out.exp_golomb(v, k);
            out.bits(v, 40);
        }
    const std::vector<std::byte> bytes = out.finish();
    BitReader in(bytes);
    for (const std::uint64_t v : values)
        for (unsigned k = 0; k < 9; k++) {
            EXPECT_EQ(in.rice(k), v);
            EXPECT_EQ(in.exp_golomb(k), v);
            EXPECT_EQ(in.bits(40), v);
        }
    EXPECT_TRUE(in.at_clean_end());
}

TEST(BitStream, reading_past_the_end_returns_zeros_and_sets_the_flag) {
    const std::byte one[] = {std::byte{0xff}};
    BitReader in(one);
    EXPECT_EQ(in.bits(8), 0xffu);
    EXPECT_FALSE(in.past_end());
    EXPECT_EQ(in.bits(8), 0u);
    EXPECT_TRUE(in.past_end());
}

TEST(BitStream, zig_zag_maps_small_magnitudes_to_small_numbers) {
    EXPECT_EQ(zig_zag_encode(0), 0u);
    EXPECT_EQ(zig_zag_encode(-1), 1u);
    EXPECT_EQ(zig_zag_encode(1), 2u);
    for (const std::int64_t v : {-4294967295ll, -3ll, 7ll, 4294967295ll})
        EXPECT_EQ(zig_zag_decode(zig_zag_encode(v)), v);
}

TEST(Crc32, matches_the_standard_check_value) {
    const char text[] = "123456789";
    EXPECT_EQ(crc32(std::as_bytes(std::span(text, 9))), 0xCBF43926u);
}

}  // namespace jostle::snapshot
