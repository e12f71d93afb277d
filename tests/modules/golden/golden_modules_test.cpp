// SPDX-License-Identifier: MIT
//
// The committed golden channels are what modules tell today. clients/web reads the same.
#include "tests/modules/golden/golden_modules.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace jostle::modules {
namespace {

// All of a file is numbers of 32 bits.
std::vector<std::int32_t> numbers_of(std::string_view bytes) {
    std::vector<std::int32_t> numbers(bytes.size() / 4);
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * 4);
    return numbers;
}

TEST(GoldenModules, committed_files_match_current_module_output) {
    // A portable build rounds otherwise, so what is told may be the step beside.
    const std::int64_t beside = arithmetic() == Arithmetic::fused ? 0 : 1;
    for (const GoldenModule& module : golden_modules()) {
        std::ifstream in(GOLDEN_FOLDER "/" + module.tag + ".bin", std::ios::binary);
        ASSERT_TRUE(in) << module.tag;
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        const std::vector<std::byte> bytes = file_bytes(module.channels);
        ASSERT_EQ(text.size(), bytes.size()) << module.tag;
        const auto golden = numbers_of(text);
        const auto told = numbers_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        for (std::size_t i = 0; i < golden.size(); i++)
            ASSERT_LE(std::abs(std::int64_t{told[i]} - golden[i]), beside)
                << module.tag << " number " << i << ": " << told[i] << ", not " << golden[i]
                << "; if its layout was meant to change, run golden_modules proto/golden_modules";
    }
}

// Numbers by the layouts that the headers state: of a boat, three characters, two walls, two waves,
// wind with an attraction and a blast, two figures, a car.
TEST(GoldenModules, channel_lengths_match_documented_layouts) {
    const std::vector<std::vector<std::size_t>> sizes = {
        {6}, {4, 4, 4}, {2 * 3}, {3 + 2 * 5, 1 + (1 + 4) + (1 + 3) + 4}, {1, 1}, {2 + 4 * 9}};
    const std::vector<GoldenModule> modules = golden_modules();
    ASSERT_EQ(modules.size(), sizes.size());
    for (std::size_t k = 0; k < modules.size(); k++) {
        std::vector<std::size_t> told;
        for (const auto& channel : modules[k].channels) told.push_back(channel.values.size());
        EXPECT_EQ(told, sizes[k]) << modules[k].tag;
    }
}

}  // namespace
}  // namespace jostle::modules
