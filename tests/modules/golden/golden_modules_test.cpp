// SPDX-License-Identifier: MIT
//
// The committed golden channels equal the current output of the modules. clients/web reads the same
// file.
#include "tests/modules/golden/golden_modules.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace jostle::modules {
namespace {

// The module of a line, and its numbers.
struct Line {
    std::string tag;
    std::vector<std::int64_t> numbers;
};
Line parse(const std::string& text) {
    std::istringstream in(text);
    Line line;
    in >> line.tag;
    for (std::int64_t number; in >> number;) line.numbers.push_back(number);
    return line;
}

TEST(GoldenModules, committed_file_matches_current_module_output) {
    // A portable build rounds differently, so quantized values may differ by one step.
    const std::int64_t tolerance = arithmetic() == Arithmetic::fused ? 0 : 1;
    const std::string hint = "; if the change is intended, run golden_modules " GOLDEN_FILE;
    std::ifstream in(GOLDEN_FILE);
    std::string text;
    for (const GoldenModule& module : golden_modules())
        for (const auto& channel : module.channels) {
            ASSERT_TRUE(std::getline(in, text)) << module.tag << hint;
            const Line golden = parse(text), current = parse(line_of(module.tag, channel));
            ASSERT_EQ(golden.tag, current.tag) << hint;
            ASSERT_EQ(golden.numbers.size(), current.numbers.size()) << text << hint;
            for (std::size_t i = 0; i < golden.numbers.size(); i++)
                ASSERT_LE(std::abs(current.numbers[i] - golden.numbers[i]), tolerance)
                    << module.tag << " number " << i << ": " << current.numbers[i] << ", not "
                    << golden.numbers[i] << hint;
        }
    EXPECT_FALSE(std::getline(in, text)) << text << hint;
}

// Lengths according to the layouts in the headers, for a boat, three characters, two walls, two
// waves, wind with an attraction and an explosion, two figures and a car.
TEST(GoldenModules, channel_lengths_match_documented_layouts) {
    const std::vector<std::vector<std::size_t>> sizes = {
        {6}, {4, 4, 4}, {2 * 3}, {3 + 2 * 5, 1 + (1 + 4) + (1 + 3) + 4}, {1, 1}, {2 + 4 * 9}};
    const std::vector<GoldenModule> modules = golden_modules();
    ASSERT_EQ(modules.size(), sizes.size());
    for (std::size_t k = 0; k < modules.size(); k++) {
        std::vector<std::size_t> current;
        for (const auto& channel : modules[k].channels) current.push_back(channel.values.size());
        EXPECT_EQ(current, sizes[k]) << modules[k].tag;
    }
}

}  // namespace
}  // namespace jostle::modules
