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

TEST(GoldenHashes, are_what_they_were) {
    std::ifstream file(GOLDEN_HASHES);
    ASSERT_TRUE(file) << "cannot read " << GOLDEN_HASHES;
    std::stringstream golden;
    golden << file.rdbuf();
    EXPECT_EQ(golden_lines(), golden.str());
}

}  // namespace
}  // namespace jostle::test
