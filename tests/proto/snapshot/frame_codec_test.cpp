// SPDX-License-Identifier: MIT
#include "jostle/snapshot/frame_codec.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {
namespace {

std::vector<QuantizedFrame> run(std::uint32_t seed, std::size_t bodies, std::uint32_t frames,
                                MotionStyle style, const QuantSpec& spec = {}) {
    MovingWorld world(seed, bodies, style);
    std::vector<QuantizedFrame> out;
    for (std::uint32_t f = 1; f <= frames; f++) out.push_back(world.step(f, spec));
    return out;
}

const QuantizedFrame* at(const std::vector<QuantizedFrame>& frames, std::ptrdiff_t i) {
    return i < 0 ? nullptr : &frames[static_cast<std::size_t>(i)];
}

constexpr Codec codecs[] = {Codec::bits, Codec::range};
constexpr std::size_t most_entities = 1u << 20;

void expect_round_trip(const QuantizedFrame& frame, const Baselines& baselines,
                       const QuantSpec& spec) {
    for (const Codec codec : codecs) {
        const auto bytes = encode_frame(frame, baselines, spec, codec);
        const auto back = decode_frame(frame.frame, bytes, baselines, spec, most_entities, codec);
        ASSERT_TRUE(back.ok()) << back.error().message << " in frame " << frame.frame;
        ASSERT_EQ(*back, frame);
        ASSERT_EQ(frame_crc(*back), frame_crc(frame));
    }
}

}  // namespace

TEST(FrameCodec, round_trips_an_active_world_at_any_baseline_spacing) {
    for (const QuantSpec spec : {QuantSpec{512, 511}, QuantSpec{4096, 16383}}) {
        const auto frames = run(3, 60, 120, {}, spec);
        const std::ptrdiff_t spacings[][3] = {
            {1, 1, 1}, {2, 2, 2}, {6, 1, 1}, {1, 3, 2}, {7, 5, 9}};
        for (const auto& s : spacings)
            for (std::ptrdiff_t i = 0; i < std::ssize(frames); i++) {
                const QuantizedFrame* base = at(frames, i - s[0]);
                const QuantizedFrame* baseline2 = base ? at(frames, i - s[0] - s[1]) : nullptr;
                const QuantizedFrame* baseline3 =
                    baseline2 ? at(frames, i - s[0] - s[1] - s[2]) : nullptr;
                const auto& frame = frames[static_cast<std::size_t>(i)];
                expect_round_trip(frame, {base, baseline2, baseline3}, spec);
                expect_round_trip(frame, {base, baseline2, nullptr}, spec);
                expect_round_trip(frame, {base, nullptr, nullptr}, spec);
            }
    }
}

// Marking unchanged runs changes neither the bytes nor the CRC.
TEST(FrameCodec, unchanged_runs_do_not_alter_the_encoding) {
    std::mt19937 random(4);
    for (int round = 0; round < 200; round++) {
        const std::size_t bodies = 1 + random() % 600;
        auto frames = run(static_cast<std::uint32_t>(round), bodies, 4, {.vanish = 0, .appear = 0});
        std::vector<UnchangedRun> unchanged;
        for (std::size_t begin = random() % 200; begin < bodies;) {
            const std::size_t end = std::min(bodies, begin + 1 + random() % 200);
            unchanged.push_back({begin, end});
            for (std::size_t k = begin; k < end; k++) {
                frames[2].entities[k].at_rest = true;
                frames[3].entities[k] = frames[2].entities[k];
            }
            begin = end + 1 + random() % 50;
        }
        const Baselines baselines{&frames[2], &frames[1], round % 3 == 0 ? nullptr : &frames[0]};
        for (const Codec codec : codecs)
            EXPECT_EQ(encode_frame(frames[3], baselines, {}, codec, unchanged),
                      encode_frame(frames[3], baselines, {}, codec));
        std::vector<std::uint32_t> blocks;
        for (std::size_t end = crc_block; end <= bodies; end += crc_block)
            blocks.push_back(
                block_crc(std::span(frames[3].entities).subspan(end - crc_block, crc_block)));
        EXPECT_EQ(frame_crc(frames[3], blocks), frame_crc(frames[3]));
        if (!blocks.empty()) blocks.pop_back();
        EXPECT_EQ(frame_crc(frames[3], blocks), frame_crc(frames[3]));
    }
}

TEST(FrameCodec, round_trips_fast_spins_and_large_jumps) {
    const auto frames = run(11, 40, 60, {.calm = 0, .spin = 150, .speed = 5000, .kick = 0.3});
    for (std::ptrdiff_t i = 3; i < std::ssize(frames); i++)
        expect_round_trip(frames[static_cast<std::size_t>(i)],
                          {at(frames, i - 1), at(frames, i - 2), at(frames, i - 3)}, {});
    QuantizedFrame low{.frame = 1}, high{.frame = 2}, low_again{.frame = 3};
    low.entities = {{.id = 5, .position = {-2147483647 - 1, 2147483647, 0}}};
    high.entities = {{.id = 5, .position = {2147483647, -2147483647 - 1, 0}}};
    low_again.entities = low.entities;
    expect_round_trip(high, {&low, nullptr, nullptr}, {});
    expect_round_trip(low_again, {&high, &low, nullptr}, {});
}

TEST(FrameCodec, resting_world_costs_at_most_4_bytes) {
    auto frames = run(5, 900, 1, {.appear = 0});
    for (EntityState& e : frames[0].entities) e.at_rest = true;
    QuantizedFrame next = frames[0];
    next.frame++;
    EXPECT_LE(encode_frame(next, {&frames[0], nullptr, nullptr}, {}).size(), 4u);
    EXPECT_LE(encode_frame(next, {&frames[0], nullptr, nullptr}, {}, Codec::range).size(), 1u);
}

TEST(FrameCodec, free_flight_costs_at_most_12_bits) {
    // At constant velocity the prediction is exact up to rounding noise.
    const auto frames =
        run(9, 400, 60, {.calm = 0, .kick = 0, .rest = 0, .vanish = 0, .appear = 0});
    std::size_t bytes = 0, moving = 0;
    for (std::ptrdiff_t i = 3; i < std::ssize(frames); i++) {
        bytes += encode_frame(frames[static_cast<std::size_t>(i)],
                              {at(frames, i - 1), at(frames, i - 2), at(frames, i - 3)}, {})
                     .size();
        moving += frames[0].entities.size();
    }
    const double bits = 8.0 * static_cast<double>(bytes) / static_cast<double>(moving);
    RecordProperty("bits_per_moving_body", std::to_string(bits));
    EXPECT_LE(bits, 12.0);
}

TEST(FrameCodec, rejects_truncated_and_flipped_bytes_or_fails_the_crc) {
    const auto frames = run(21, 50, 8, {});
    const Baselines baselines{at(frames, 6), at(frames, 5), at(frames, 4)};
    const std::uint32_t crc = frame_crc(frames[7]);
    for (const Codec codec : codecs) {
        const auto good = encode_frame(frames[7], baselines, {}, codec);
        for (std::size_t size = 0; size < good.size(); size++) {
            const auto back =
                decode_frame(8, std::span(good).first(size), baselines, {}, most_entities, codec);
            EXPECT_TRUE(!back.ok() || frame_crc(*back) != crc) << "cut at " << size;
        }
        Random random(1);
        int refused = 0, the_same = 0;
        for (int i = 0; i < 10000; i++) {
            auto bad = good;
            for (std::uint32_t k = 0; k <= random.below(3); k++)
                bad[random.below(static_cast<std::uint32_t>(bad.size()))] ^=
                    static_cast<std::byte>(1u << random.below(8));
            if (bad == good) continue;
            const auto back = decode_frame(8, bad, baselines, {}, most_entities, codec);
            if (back.ok()) {
                the_same += *back == frames[7] ? 1 : 0;
            } else {
                EXPECT_EQ(back.error().code, ErrorCode::corrupt_data);
                refused++;
            }
        }
        EXPECT_GT(refused, 500);
        // The last byte of a range coder has spare bits.
        EXPECT_LT(the_same, codec == Codec::bits ? 1 : 100);
    }
}

TEST(FrameCodec, random_bytes_never_exceed_the_entity_limit) {
    Random random(99);
    for (int i = 0; i < 20000; i++) {
        std::vector<std::byte> noise(random.below(64));
        for (std::byte& b : noise) b = static_cast<std::byte>(random.below(256));
        const auto back = decode_frame(1, noise, {}, {}, 100, codecs[i % 2]);
        if (back.ok()) {
            EXPECT_LE(back->entities.size(), 100u);
        } else {
            EXPECT_FALSE(back.error().message.empty());
        }
    }
}

TEST(FrameCodec, rejects_baselines_too_old_or_not_older) {
    const QuantizedFrame empty{.frame = 300};
    const auto bytes = encode_frame(empty, {}, {});
    QuantizedFrame base{.frame = 10};
    EXPECT_FALSE(decode_frame(300, bytes, {&base, nullptr, nullptr}, {}).ok());
    base.frame = 300;
    EXPECT_FALSE(decode_frame(300, bytes, {&base, nullptr, nullptr}, {}).ok());
}

TEST(FrameCodec, rejects_quantization_that_would_overflow) {
    const auto frames = run(4, 20, 4, {.calm = 0});
    const Baselines baselines{at(frames, 2), at(frames, 1), at(frames, 0)};
    const auto bytes = encode_frame(frames[3], baselines, {});
    for (const QuantSpec bad : {QuantSpec{0, 511}, QuantSpec{-1, 511}, QuantSpec{512, 0},
                                QuantSpec{512, -1}, QuantSpec{512, 16384}, QuantSpec{65537, 511}}) {
        const auto back = decode_frame(4, bytes, baselines, bad);
        ASSERT_FALSE(back.ok());
        EXPECT_NE(back.error().message.find("quantization"), std::string::npos)
            << back.error().message;
    }
}

}  // namespace jostle::snapshot
