// SPDX-License-Identifier: MIT
//
// A changed hash is a changed result, down to the last bit. If it is meant: run
// build/PRESET/bin/golden_hashes and say why in docs/format_changes.md.
#include "determinism/golden_hashes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace jostle::test {
namespace {

std::string golden() {
    std::ifstream file(GOLDEN_HASHES);
    EXPECT_TRUE(file) << "cannot read " << GOLDEN_HASHES;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(GoldenHashes, are_what_they_were) {
    EXPECT_EQ(golden_lines(), golden());
}

// One to eight threads, and every instruction set that this machine has, in turn.
TEST(GoldenHashes, do_not_depend_on_threads_or_instructions) {
    const physics::InstructionSet usual = physics::instruction_set();
    const auto sets = physics::available_instruction_sets();
    for (std::size_t k = 0; k < std::max<std::size_t>(8, sets.size()); k++) {
        const int threads = static_cast<int>(k % 8) + 1;
        must(physics::use_instruction_set(sets[k % sets.size()]));
        EXPECT_EQ(golden_lines(threads), golden())
            << threads << " threads, " << physics::instruction_set_name(physics::instruction_set());
    }
    must(physics::use_instruction_set(usual));
}

}  // namespace
}  // namespace jostle::test
