// SPDX-License-Identifier: MIT
//
// The committed golden files are what the encoder makes today, and the decoder reads them. clients/web decodes the same.
#include "wire/golden.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace jostle::wire {

TEST(Golden, committed_files_are_what_the_encoder_makes_today) {
    for (const GoldenSequence& sequence : golden_sequences()) {
        std::ifstream in(std::string(GOLDEN_FOLDER) + "/" + sequence.name + ".bin",
                         std::ios::binary);
        ASSERT_TRUE(in) << sequence.name;
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        const auto made = golden_file(sequence);
        ASSERT_EQ(text.size(), made.size()) << sequence.name;
        for (std::size_t i = 0; i < made.size(); i++)
            ASSERT_EQ(static_cast<std::byte>(text[i]), made[i]) << sequence.name << " byte " << i;
    }
}

// A golden set that missed a path would prove little: count what the sequences exercise.
TEST(Golden, sequences_take_the_rare_paths) {
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

}  // namespace jostle::wire
