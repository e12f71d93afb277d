// SPDX-License-Identifier: MIT
//
// The committed golden channels equal the current output of the modules. clients/web reads the same
// files.
#include "tests/modules/golden/golden_modules.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace jostle::modules {
namespace {

// A file consists of 32-bit integers.
std::vector<std::int32_t> numbers_of(std::string_view bytes) {
    std::vector<std::int32_t> numbers(bytes.size() / 4);
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * 4);
    return numbers;
}

TEST(GoldenModules, committed_files_match_current_module_output) {
    // A portable build rounds differently, so quantized values may differ by one step.
    const std::int64_t tolerance = arithmetic() == Arithmetic::fused ? 0 : 1;
    for (const GoldenModule& module : golden_modules()) {
        std::ifstream in(GOLDEN_FOLDER "/" + module.tag + ".bin", std::ios::binary);
        ASSERT_TRUE(in) << module.tag;
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        const std::vector<std::byte> bytes = file_bytes(module.channels);
        ASSERT_EQ(text.size(), bytes.size()) << module.tag;
        const auto golden = numbers_of(text);
        const auto current =
            numbers_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        for (std::size_t i = 0; i < golden.size(); i++)
            ASSERT_LE(std::abs(std::int64_t{current[i]} - golden[i]), tolerance)
                << module.tag << " number " << i << ": " << current[i] << ", not " << golden[i]
                << "; if the change is intended, run golden_modules proto/golden_modules";
    }
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
