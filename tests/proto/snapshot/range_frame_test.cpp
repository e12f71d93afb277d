// SPDX-License-Identifier: MIT
//
// Codec 2 alone: its size and its checks. frame_codec_test.cpp tests the properties of both codecs.
#include "jostle/snapshot/range_frame.h"

#include <gtest/gtest.h>

#include "jostle/snapshot/frame_codec.h"
#include "jostle/snapshot/range_frame_serializer.h"
#include "jostle/snapshot/start_models.h"
#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {
namespace {

constexpr std::size_t most = 1u << 20;

QuantizedFrame resting(std::uint32_t frame, std::uint32_t count) {
    QuantizedFrame made{.frame = frame, .entities = {}};
    for (std::uint32_t id = 1; id <= count; id++)
        made.entities.push_back({.id = id, .position = {512, 0, 0}, .at_rest = true});
    return made;
}

// Encodes lists that a valid encoder never produces, up to the invalid item.
std::vector<std::byte> encoded(EntityChanges lists, const QuantizedFrame* baseline) {
    FrameModels models = start_models(1);
    RangeEncoder out;
    RangeFrameSerializer walk(out, models, QuantSpec{});
    walk.entities(lists, {baseline, nullptr, nullptr}, most);
    return out.finish();
}

std::string refusal(const std::vector<std::byte>& bytes, const Baselines& baselines,
                    std::size_t limit = most) {
    const auto back = decode_frame(2, bytes, baselines, {}, limit, Codec::range);
    return back.ok() ? "" : back.error().message;
}

}  // namespace

TEST(RangeFrame, uses_less_than_75_percent_of_codec_1_for_tumbling_bodies) {
    MovingWorld world(9, 400, {.calm = 0.3, .kick = 0.01});
    std::vector<QuantizedFrame> frames;
    std::size_t bits = 0, range = 0;
    for (std::uint32_t f = 1; f <= 40; f++) {
        frames.push_back(world.step(f, {}));
        if (f < 4) continue;
        const Baselines baselines{&frames[f - 2], &frames[f - 3], &frames[f - 4]};
        bits += encode_frame(frames.back(), baselines, {}, Codec::bits).size();
        range += encode_frame(frames.back(), baselines, {}, Codec::range).size();
    }
    RecordProperty("share", std::to_string(static_cast<double>(range) / static_cast<double>(bits)));
    EXPECT_LT(range, bits * 3 / 4);
}

// A keyframe of a grid of 900 cubes: neighbours differ little.
TEST(RangeFrame, keyframe_of_a_grid_uses_less_than_half_of_codec_1) {
    QuantizedFrame grid{.frame = 1, .entities = {}};
    for (std::uint32_t i = 0; i < 900; i++)
        grid.entities.push_back(
            quantize(i + 1, {{0.8 * (i % 30), 0.2, 0.8 * (i / 30)}, {0, 0, 0, 1}}, true, {}));
    const std::size_t bits = encode_frame(grid, {}, {}, Codec::bits).size();
    EXPECT_LT(encode_frame(grid, {}, {}, Codec::range).size(), bits / 2);
}

TEST(RangeFrame, initial_models_match_the_table) {
    for (const std::string_view letters : start_model_letters)
        EXPECT_EQ(letters.size(), frame_model_count);
    for (const std::int64_t age : {1, 2, 3, 200}) {
        FrameModels models = start_models(age);
        for (const BitModel& model : all_of(models)) {
            EXPECT_GE(model.one, 64);
            EXPECT_LE(model.one, 65472);
            EXPECT_TRUE(model.seen == 0 || model.seen == 8);
        }
    }
}

TEST(RangeFrame, rejects_invalid_data_by_name) {
    const QuantizedFrame ten = resting(1, 10), three = resting(1, 3);
    QuantizedFrame ninth_wakes = resting(2, 10);
    ninth_wakes.entities[8].at_rest = false;
    const auto wakes = encode_frame(ninth_wakes, {&ten, nullptr, nullptr}, {}, Codec::range);
    EXPECT_EQ(refusal(wakes, {&ten, nullptr, nullptr}), "");
    EXPECT_EQ(
        refusal(wakes, {&three, nullptr, nullptr}),
        "run of resting entities exceeds the frame (at byte " + std::to_string(wakes.size()) + ")");

    const Baselines baselines{&three, nullptr, nullptr};
    const auto has = [](const std::string& message, const char* what) {
        EXPECT_EQ(message.rfind(what, 0), 0u) << what << ": " << message;
        EXPECT_NE(message.find(" (at byte "), std::string::npos) << message;
    };
    has(refusal(encoded({.removed = {0, 1, 2, 2}, .spawned = {}}, &ten), baselines),
        "removed: count exceeds the baseline");
    has(refusal(encoded({.removed = {7}, .spawned = {}}, &ten), baselines),
        "removed: position past the end");
    has(refusal(encoded({.removed = {}, .spawned = {{.id = 2}}}, &three), baselines),
        "spawned: id exists in the baseline");
    has(refusal(encoded({.removed = {}, .spawned = {{.id = 5}, {.id = 5}}}, nullptr), {}),
        "spawned: id exceeds 32 bits");
    has(refusal(encoded({.removed = {}, .spawned = resting(1, 200).entities}, nullptr), {}, 100),
        "spawned: the number of entities exceeds the limit");
    has(refusal(
            encoded({.removed = {}, .spawned = {{.id = 1, .rotation = {511, 511, 511}}}}, nullptr),
            {}),
        "invalid rotation");
    has(refusal(encode_frame(resting(2, 3), {}, {}, Codec::range), {}, 2),
        "spawned: the number of entities exceeds the limit");
    has(refusal(encode_frame(resting(2, 3), baselines, {}, Codec::range), baselines, 2),
        "the number of entities exceeds the limit");

    MovingWorld world(3, 50, {});
    auto bytes = encode_frame(world.step(2, {}), {}, {}, Codec::range);
    EXPECT_EQ(refusal(bytes, {}), "");
    bytes.insert(bytes.end(), 8, std::byte{7});
    has(refusal(bytes, {}), "unexpected bytes at the end");
    bytes.resize(bytes.size() / 2);
    has(refusal(bytes, {}), "truncated data");
}

}  // namespace jostle::snapshot
