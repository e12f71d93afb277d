// SPDX-License-Identifier: MIT
//
// The golden frames: sequences of frames that together exercise every path of the codec. Each is a
// file proto/golden/NAME.bin for codec 1 and range_NAME.bin for codec 2 (WIRE.md, "Golden frames",
// specifies the layout). C++ and TypeScript decode the same files.
#pragma once

#include <string>
#include <vector>

#include "jostle/snapshot/frame_codec.h"
#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {

struct GoldenFrame {
    QuantizedFrame frame;
    std::uint32_t base = 0, baseline2 = 0, baseline3 = 0;  // frame numbers; 0: none
};

struct GoldenSequence {
    std::string name;
    QuantSpec spec;
    std::vector<GoldenFrame> frames;  // each may refer to earlier frames
};

inline std::vector<GoldenSequence> golden_sequences() {
    struct Plan {
        const char* name;
        QuantSpec spec;
        std::uint32_t seed;
        std::size_t bodies;
        MotionStyle style;
        std::uint32_t steps[4];  // ticks between frames, repeated
    };
    const Plan plans[] = {
        {"steady", {}, 1, 12, {}, {1, 1, 1, 1}},
        {"skips", {}, 2, 12, {.calm = 0.1}, {1, 3, 6, 2}},
        {"all_moving", {}, 3, 16, {.calm = 0, .kick = 0.1, .rest = 0, .vanish = 0}, {1, 1, 2, 1}},
        {"fast_spin", {}, 4, 8, {.calm = 0, .spin = 150, .speed = 3000, .kick = 0.3}, {1, 1, 1, 2}},
        {"restless",
         {},
         5,
         10,
         {.calm = 0.5, .rest = 0.4, .vanish = 0.1, .appear = 1},
         {1, 2, 1, 1}},
        {"precise", {4096, 16383}, 6, 8, {.calm = 0.2}, {1, 1, 3, 2}},
        {"empty", {}, 7, 0, {.appear = 0}, {1, 1, 1, 1}},
    };
    std::vector<GoldenSequence> sequences;
    for (const Plan& plan : plans) {
        GoldenSequence sequence{.name = plan.name, .spec = plan.spec};
        MovingWorld world(plan.seed, plan.bodies, plan.style);
        std::uint32_t tick = 0;
        for (std::size_t i = 0; i < 24; i++) {
            const std::uint32_t ticks = plan.steps[i % 4];
            GoldenFrame golden;
            for (std::uint32_t k = 0; k < ticks; k++) golden.frame = world.step(++tick, plan.spec);
            const auto number = [&](std::size_t back) {
                return i >= back ? sequence.frames[i - back].frame.frame : 0;
            };
            // Every seventh frame is absolute; in between the number of baselines varies.
            if (i % 7 != 0) golden.base = number(1);
            if (golden.base != 0 && i % 5 != 0) golden.baseline2 = number(2);
            if (golden.baseline2 != 0 && i % 6 != 0) golden.baseline3 = number(3);
            sequence.frames.push_back(std::move(golden));
        }
        sequences.push_back(std::move(sequence));
    }
    return sequences;
}

inline std::string golden_name(const GoldenSequence& sequence, Codec codec) {
    return (codec == Codec::range ? "range_" : "") + sequence.name + ".bin";
}

// The file: "JGLD", u32 codec, u32 units_per_meter, u32 M, u32 frames; per frame u32 frame,
// baseline, baseline2, baseline3, crc, entities, packed bytes, then per entity u32 id, i32 x y z,
// u8 largest, i16 r r r, u8 at_rest, then the packed bytes.
inline std::vector<std::byte> golden_file(const GoldenSequence& sequence, Codec codec) {
    std::vector<std::byte> out;
    const auto put = [&](std::uint32_t value, int size = 4) {
        for (int k = 0; k < size; k++) out.push_back(static_cast<std::byte>(value >> (8 * k)));
    };
    for (const char c : {'J', 'G', 'L', 'D'}) out.push_back(static_cast<std::byte>(c));
    put(static_cast<std::uint32_t>(codec));
    put(static_cast<std::uint32_t>(sequence.spec.units_per_meter));
    put(static_cast<std::uint32_t>(sequence.spec.rotation_component));
    put(static_cast<std::uint32_t>(sequence.frames.size()));
    const auto find = [&](std::uint32_t number) -> const QuantizedFrame* {
        for (const GoldenFrame& g : sequence.frames)
            if (number != 0 && g.frame.frame == number) return &g.frame;
        return nullptr;
    };
    for (const GoldenFrame& g : sequence.frames) {
        const auto packed = encode_frame(
            g.frame, {find(g.base), find(g.baseline2), find(g.baseline3)}, sequence.spec, codec);
        put(g.frame.frame);
        put(g.base);
        put(g.baseline2);
        put(g.baseline3);
        put(frame_crc(g.frame));
        put(static_cast<std::uint32_t>(g.frame.entities.size()));
        put(static_cast<std::uint32_t>(packed.size()));
        for (const EntityState& e : g.frame.entities) {
            put(e.id);
            for (const std::int32_t p : e.position) put(static_cast<std::uint32_t>(p));
            put(e.largest, 1);
            for (const std::int16_t r : e.rotation) put(static_cast<std::uint16_t>(r), 2);
            put(e.at_rest ? 1 : 0, 1);
        }
        out.insert(out.end(), packed.begin(), packed.end());
    }
    return out;
}

}  // namespace jostle::snapshot
