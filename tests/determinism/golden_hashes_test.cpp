// SPDX-License-Identifier: MIT
//
// A changed hash means that results changed in at least one bit. If the change is intended, run
// build/PRESET/bin/golden_hashes and explain the change in docs/design/format_changes.md.
// scripts/determinism-check covers other compilers and CPUs.
#include "tests/determinism/golden_hashes.h"

#include <gtest/gtest.h>

#include <fstream>

namespace jostle::test {
namespace {

std::vector<std::string> golden() {
    std::ifstream file(GOLDEN_HASHES);
    EXPECT_TRUE(file) << "cannot read " << GOLDEN_HASHES;
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

// One to four threads with all instruction sets of this machine in turn. scripts/determinism-check
// covers up to eight threads.
TEST(GoldenHashes, match_for_any_thread_count_and_instruction_set) {
    const physics::InstructionSet usual = physics::instruction_set();
    for (const GoldenConfiguration& configuration : golden_configurations(4)) {
        must(physics::use_instruction_set(configuration.set));
        EXPECT_EQ(golden_lines(configuration.threads), golden()) << to_string(configuration);
    }
    must(physics::use_instruction_set(usual));
}

}  // namespace
}  // namespace jostle::test
