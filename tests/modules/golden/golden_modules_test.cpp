// SPDX-License-Identifier: MIT
//
// The committed golden bytes are what modules tell today. clients/web reads the same.
#include "modules/golden/golden_modules.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace jostle::modules {

TEST(GoldenModules, committed_files_are_what_modules_tell_today) {
    if (arithmetic() != Arithmetic::fused)
        GTEST_SKIP() << "a portable build rounds otherwise: a number may be a step beside";
    for (const GoldenModule& module : golden_modules()) {
        std::ifstream in(GOLDEN_FOLDER "/" + module.tag + ".bin", std::ios::binary);
        ASSERT_TRUE(in) << module.tag;
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        ASSERT_EQ(text.size(), module.bytes.size()) << module.tag;
        for (std::size_t i = 0; i < text.size(); i++)
            ASSERT_EQ(static_cast<std::byte>(text[i]), module.bytes[i])
                << module.tag << " byte " << i
                << "; if its layout was meant to change, run golden_modules proto/golden_modules";
    }
}

// Sizes by the layouts that the headers state: a boat, three characters, two walls, ..., a car.
TEST(GoldenModules, are_as_long_as_their_layouts_say) {
    const std::size_t sizes[] = {
        13,    3 * 8,     2 + 2 * 6, 1 + (4 + 4 + 1 + 2 * 16) + 1 + (1 + 16) + (1 + 12) + 1 + 16,
        2 * 5, 7 + 4 * 15};
    const std::vector<GoldenModule> modules = golden_modules();
    ASSERT_EQ(modules.size(), std::size(sizes));
    for (std::size_t k = 0; k < modules.size(); k++)
        EXPECT_EQ(modules[k].bytes.size(), sizes[k]) << modules[k].tag;
}

}  // namespace jostle::modules
