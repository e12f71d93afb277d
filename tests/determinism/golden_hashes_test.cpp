// SPDX-License-Identifier: MIT
//
// A changed hash is a changed result, down to the last bit. If it is meant: run
// build/PRESET/bin/golden_hashes and say why in docs/design/format_changes.md. Other compilers and
// CPUs: scripts/determinism-check.
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

// One to four threads, and every instruction set that this machine has, in turn.
// scripts/determinism-check goes on to eight.
TEST(GoldenHashes, match_for_any_thread_count_and_instruction_set) {
    const physics::InstructionSet usual = physics::instruction_set();
    for (const GoldenConfiguration& way : golden_configurations(4)) {
        must(physics::use_instruction_set(way.set));
        EXPECT_EQ(golden_lines(way.threads), golden()) << to_string(way);
    }
    must(physics::use_instruction_set(usual));
}

}  // namespace
}  // namespace jostle::test
