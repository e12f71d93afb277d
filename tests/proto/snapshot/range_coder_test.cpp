// SPDX-License-Identifier: MIT
#include "jostle/snapshot/range_coder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {
namespace {

// Bits, one in `sparse` of them a one, mixed with raw numbers of every width.
struct Message {
    std::vector<bool> bits;
    std::vector<std::uint64_t> numbers;
};

Message message(std::uint32_t seed, std::uint32_t sparse, std::size_t size) {
    Random random(seed);
    Message m;
    for (std::size_t i = 0; i < size; i++) {
        m.bits.push_back(random.below(sparse) == 0);
        const std::uint64_t wide =
            std::uint64_t{random.below(1u << 20)} << 20 | random.below(1u << 20);
        m.numbers.push_back(wide & ((std::uint64_t{1} << (i % 41)) - 1));
    }
    return m;
}

}  // namespace

TEST(RangeCoder, round_trips_bits_and_numbers_of_every_width) {
    for (const std::uint32_t sparse : {1u, 2u, 3u, 50u, 4000u}) {
        const Message told = message(sparse, sparse, 3000);
        RangeEncoder out;
        BitModel model;
        for (unsigned i = 0; i < told.bits.size(); i++) {
            out.bit(model, told.bits[i]);
            out.raw(told.numbers[i], i % 41);
        }
        const auto bytes = out.finish();
        RangeDecoder in(bytes);
        BitModel again;
        for (unsigned i = 0; i < told.bits.size(); i++) {
            ASSERT_EQ(in.bit(again), told.bits[i]) << sparse << ": " << i;
            ASSERT_EQ(in.raw(0, i % 41), told.numbers[i]) << sparse << ": " << i;
        }
        EXPECT_TRUE(in.at_clean_end());
    }
}

// Entropy of one in fifty: 0.141 bits each.
TEST(RangeCoder, comes_within_three_percent_of_the_entropy) {
    const Message told = message(7, 50, 100'000);
    RangeEncoder out;
    BitModel model;
    double ones = 0;
    for (const bool bit : told.bits) {
        out.bit(model, bit);
        ones += bit ? 1 : 0;
    }
    const double p = ones / 1e5;
    const double entropy = -1e5 * (p * std::log2(p) + (1 - p) * std::log2(1 - p)) / 8;
    EXPECT_LT(static_cast<double>(out.finish().size()), 1.03 * entropy);
}

// A run of 255 bytes that a carry turns into 0: the value approaches a boundary slowly.
TEST(RangeCoder, propagates_carry_through_pending_bytes) {
    RangeEncoder out;
    out.raw(0x12ff'ffff'ffull, 40);
    out.raw(0xffff'ffff'ffull, 40);
    BitModel model;
    for (int i = 0; i < 40; i++) out.bit(model, false);
    out.raw(1, 1);
    const auto bytes = out.finish();
    RangeDecoder in(bytes);
    BitModel again;
    EXPECT_EQ(in.raw(0, 40), 0x12ff'ffff'ffull);
    EXPECT_EQ(in.raw(0, 40), 0xffff'ffff'ffull);
    for (int i = 0; i < 40; i++) EXPECT_FALSE(in.bit(again));
    EXPECT_EQ(in.raw(0, 1), 1u);
}

TEST(RangeCoder, detects_missing_and_trailing_bytes) {
    RangeEncoder out;
    for (std::uint64_t i = 1; i < 100; i++) out.raw(i | 1, 16);
    auto bytes = out.finish();
    const auto read = [&] {
        RangeDecoder in(bytes);
        for (int i = 1; i < 100; i++) in.raw(0, 16);
        return std::pair(in.past_end(), in.at_clean_end());
    };
    EXPECT_EQ(read(), std::pair(false, true));
    bytes.resize(bytes.size() + 8, std::byte{1});
    EXPECT_EQ(read(), std::pair(false, false));
    bytes.resize(20);
    EXPECT_EQ(read(), std::pair(true, false));
}

}  // namespace jostle::snapshot
