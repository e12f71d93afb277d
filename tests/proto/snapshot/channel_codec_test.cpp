// SPDX-License-Identifier: MIT
//
// Channels of modules in snapshots: decoding restores every value and detects damage.
#include "jostle/snapshot/channel_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <fstream>
#include <iterator>
#include <limits>

#include "tests/proto/snapshot/channel_motion.h"

namespace jostle::snapshot {
namespace {

using testing::HasSubstr;
constexpr std::uint64_t all_kinds = ~std::uint64_t{0};

Channel channel(std::uint32_t kind, std::uint32_t entity, std::vector<std::int32_t> values) {
    return {kind, entity, std::make_shared<const std::vector<std::int32_t>>(std::move(values))};
}

TEST(ChannelCodec, round_trips_a_thousand_frames_against_any_baseline) {
    ChangingChannels world(3);
    std::deque<Channels> ring{{}};
    for (int frame = 0; frame < 1000; frame++) {
        const Channels& now = world.step();
        const Channels& base = ring[static_cast<std::size_t>(frame) % ring.size()];
        const PackedChannels packed = encode_channels(now, base, all_kinds);
        const auto decoded = decode_channels(packed.bytes, packed.crc, base);
        ASSERT_TRUE(decoded.ok()) << decoded.error().message;
        ASSERT_TRUE(same_channels(*decoded, now)) << "frame " << frame;
        ring.push_back(now);
        if (ring.size() > 32) ring.pop_front();
    }
}

TEST(ChannelCodec, unchanged_channels_cost_nothing_and_share_values) {
    const Channels before{channel(0, 5, {1, 2, 3}), channel(1, 5, {4})};
    EXPECT_TRUE(encode_channels(before, before, all_kinds).bytes.empty());
    const Channels after{before[0], channel(1, 5, {5})};
    const PackedChannels packed = encode_channels(after, before, all_kinds);
    EXPECT_LE(packed.bytes.size(), 3u);
    const auto decoded = decode_channels(packed.bytes, packed.crc, before);
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ((*decoded)[0].values, before[0].values) << "unchanged lists are shared, not copied";
}

TEST(ChannelCodec, encodes_only_requested_kinds) {
    const Channels base{channel(0, 1, {1}), channel(2, 1, {1})};
    const Channels now{channel(0, 1, {2}), channel(1, 1, {3}), channel(2, 1, {2})};
    const std::uint64_t odd = 0b10, even = 0b101;
    const Channels had_odd{};
    const PackedChannels packed = encode_channels(now, base, odd);
    const auto decoded = decode_channels(packed.bytes, packed.crc, had_odd);
    ASSERT_TRUE(decoded.ok());
    ASSERT_EQ(decoded->size(), 1u);
    EXPECT_EQ((*decoded)[0].kind, 1u);
    const PackedChannels others = encode_channels(now, base, even);
    EXPECT_EQ(decode_channels(others.bytes, others.crc, base)->size(), 2u);
}

TEST(ChannelCodec, differences_wrap_around) {
    constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                           high = std::numeric_limits<std::int32_t>::max();
    const Channels base{channel(0, 0, {low, high, 0, low, -1})};
    const Channels now{channel(0, 0, {high, low, low, 0, high})};
    const PackedChannels packed = encode_channels(now, base, all_kinds);
    const auto decoded = decode_channels(packed.bytes, packed.crc, base);
    ASSERT_TRUE(decoded.ok()) << decoded.error().message;
    EXPECT_TRUE(same_channels(*decoded, now));
}

// Sixteen rolling cars with 38 numbers each, of which a few change slightly.
TEST(ChannelCodec, rolling_car_costs_two_bytes_per_changed_value) {
    Channels before, now;
    for (std::uint32_t car = 1; car <= 16; car++) {
        std::vector<std::int32_t> values(38, 1000);
        before.push_back(channel(0, car, values));
        for (std::size_t wheel = 0; wheel < 4; wheel++) {
            values[2 + 9 * wheel + 3] += 5;     // its travel
            values[2 + 9 * wheel + 6] += 4000;  // its angle
            values[2 + 9 * wheel + 7] -= 3;     // its spin
        }
        now.push_back(channel(0, car, values));
    }
    const std::size_t bytes = encode_channels(now, before, all_kinds).bytes.size();
    RecordProperty("bytes_a_car", static_cast<int>(bytes / 16));
    EXPECT_LE(bytes, 16u * 24u) << "twelve changed numbers per car, four of them angles";
}

TEST(ChannelCodec, rejects_any_flipped_bit) {
    ChangingChannels world(5);
    for (int k = 0; k < 6; k++) world.step();
    const Channels base = world.step();
    const PackedChannels packed = encode_channels(world.step(), base, all_kinds);
    ASSERT_GT(packed.bytes.size(), 10u);
    for (std::size_t bit = 0; bit < packed.bytes.size() * 8; bit++) {
        std::vector<std::byte> damaged = packed.bytes;
        damaged[bit / 8] ^= std::byte{1} << (bit % 8);
        EXPECT_FALSE(decode_channels(damaged, packed.crc, base).ok()) << "bit " << bit;
    }
    for (std::size_t size = 1; size < packed.bytes.size(); size++)
        EXPECT_FALSE(decode_channels(std::span(packed.bytes).first(size), packed.crc, base).ok());
}

TEST(ChannelCodec, errors_describe_the_problem) {
    const auto error_of = [](const Channels& now, const Channels& told_base,
                             const Channels& own_base) {
        const PackedChannels packed = encode_channels(now, told_base, all_kinds);
        const auto decoded = decode_channels(packed.bytes, packed.crc, own_base);
        return decoded.ok() ? "" : decoded.error().message;
    };
    const Channels one{channel(3, 7, {1})}, other{channel(3, 7, {2})};
    EXPECT_THAT(error_of(other, one, {}),
                HasSubstr("kind 3 of entity 7 changed but is not in the baseline"));
    EXPECT_THAT(error_of({}, one, {}),
                HasSubstr("kind 3 of entity 7 ended but is not in the baseline"));
    EXPECT_THAT(
        error_of({channel(0, 0, std::vector<std::int32_t>(channel_values_max + 1))}, {}, {}),
        HasSubstr("kind 0 of entity 0 has more than 16384 values"));
    Channels many;
    for (std::uint32_t k = 0; k <= channels_max; k++) many.push_back(channel(0, k, {}));
    EXPECT_THAT(error_of(many, {}, {}), HasSubstr("more than 4096 channels"));
    Channels large;
    for (std::uint32_t k = 0; k <= frame_values_max / channel_values_max; k++)
        large.push_back(channel(0, k, std::vector<std::int32_t>(channel_values_max)));
    EXPECT_THAT(error_of(large, {}, {}), HasSubstr("more than 262144 values"));
}

TEST(ChannelCodec, encoder_output_matches_the_golden_file) {
    std::ifstream in(GOLDEN_FOLDER "/channels.jchn", std::ios::binary);
    ASSERT_TRUE(in);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    const auto made = golden_channels();
    ASSERT_EQ(text.size(), made.size());
    for (std::size_t k = 0; k < made.size(); k++)
        ASSERT_EQ(static_cast<std::byte>(text[k]), made[k]) << "byte " << k;
}

}  // namespace
}  // namespace jostle::snapshot
