// SPDX-License-Identifier: MIT
//
// The committed golden files equal the current output of the encoder, and the decoder reads them.
// clients/web decodes the same files.
#include "tests/proto/snapshot/golden.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "jostle/snapshot/predict.h"

namespace jostle::snapshot {

TEST(Golden, encoder_output_matches_the_golden_files) {
    for (const GoldenSequence& sequence : golden_sequences())
        for (const Codec codec : {Codec::bits, Codec::range}) {
            const std::string name = golden_name(sequence, codec);
            std::ifstream in(GOLDEN_FOLDER "/" + name, std::ios::binary);
            ASSERT_TRUE(in) << name;
            const std::string text((std::istreambuf_iterator<char>(in)), {});
            const auto made = golden_file(sequence, codec);
            ASSERT_EQ(text.size(), made.size()) << name;
            for (std::size_t i = 0; i < made.size(); i++)
                ASSERT_EQ(static_cast<std::byte>(text[i]), made[i]) << name << " byte " << i;
        }
}

// Counts what the sequences exercise, so that the golden set does not miss a path.
TEST(Golden, sequences_cover_rare_code_paths) {
    int spawned_later = 0, removed = 0, rests = 0, largest_changes = 0, absolute = 0;
    for (const GoldenSequence& sequence : golden_sequences()) {
        const GoldenFrame* before = nullptr;
        for (const GoldenFrame& g : sequence.frames) {
            absolute += g.base == 0 ? 1 : 0;
            if (before && g.base != 0)
                for (const EntityState& e : g.frame.entities) {
                    bool found = false;
                    for (const EntityState& old : before->frame.entities) {
                        if (old.id != e.id) continue;
                        found = true;
                        rests += old.at_rest != e.at_rest ? 1 : 0;
                        largest_changes += old.largest != e.largest ? 1 : 0;
                    }
                    spawned_later += found ? 0 : 1;
                }
            if (before)
                for (const EntityState& old : before->frame.entities) {
                    bool found = false;
                    for (const EntityState& e : g.frame.entities) found = found || e.id == old.id;
                    removed += found ? 0 : 1;
                }
            before = &g;
        }
    }
    EXPECT_GT(absolute, 20);
    EXPECT_GT(spawned_later, 20);
    EXPECT_GT(removed, 20);
    EXPECT_GT(rests, 50);
    EXPECT_GT(largest_changes, 50);
}

// Arithmetic that could differ between languages: negative steps scaled over unequal spacings,
// rotations too fast to extrapolate, rotations written in full, baselines at rest.
TEST(Golden, sequences_cover_arithmetic_limits) {
    int scaled_negative = 0, held_turns = 0, wrong_largest = 0, from_rest = 0, no_base2 = 0,
        no_base3 = 0;
    const auto find = [](const QuantizedFrame& frame, std::uint32_t id) -> const EntityState* {
        for (const EntityState& e : frame.entities)
            if (e.id == id) return &e;
        return nullptr;
    };
    for (const GoldenSequence& sequence : golden_sequences()) {
        const auto frame_of = [&](std::uint32_t number) {
            for (const GoldenFrame& g : sequence.frames)
                if (g.frame.frame == number) return g.frame;
            return QuantizedFrame{};
        };
        const std::int64_t m = sequence.spec.rotation_component;
        for (const GoldenFrame& g : sequence.frames) {
            const QuantizedFrame base = frame_of(g.base), baseline2 = frame_of(g.baseline2),
                                 baseline3 = frame_of(g.baseline3);
            const Spacing t{g.base ? g.frame.frame - g.base : 1,
                            g.baseline2 ? g.base - g.baseline2 : 1,
                            g.baseline3 ? g.baseline2 - g.baseline3 : 1};
            for (const EntityState& now : g.frame.entities) {
                const EntityState* b1 = find(base, now.id);
                if (!b1 || same_pose(now, *b1)) continue;
                const EntityState* b2 = find(baseline2, now.id);
                const EntityState* b3 = b2 ? find(baseline3, now.id) : nullptr;
                from_rest += b1->at_rest ? 1 : 0;
                no_base2 += b2 ? 0 : 1;
                no_base3 += b2 && !b3 ? 1 : 0;
                const Prediction p = predict(*b1, b2, b3, t, sequence.spec);
                wrong_largest += p.largest != now.largest ? 1 : 0;
                if (!b2 || b1->at_rest) continue;
                if (t.dt1 != t.dt2 && b1->position[0] < b2->position[0]) scaled_negative++;
                // Hold: the prediction keeps the rotation although the body rotated.
                const Prediction still = predict(*b1, nullptr, nullptr, t, sequence.spec);
                const bool turned = b1->largest != b2->largest || b1->rotation != b2->rotation;
                if (turned && p.rotation == still.rotation && p.rotation_change > m) held_turns++;
            }
        }
    }
    EXPECT_GT(scaled_negative, 20);
    EXPECT_GT(held_turns, 20);
    EXPECT_GT(wrong_largest, 20);
    EXPECT_GT(from_rest, 10);
    EXPECT_GT(no_base2, 20);
    EXPECT_GT(no_base3, 20);
}

}  // namespace jostle::snapshot
