// SPDX-License-Identifier: MIT
#include "modules/ragdoll/gltf/src/base64.h"

#include <gtest/gtest.h>

#include "tests/modules/ragdoll/gltf/gltf_skeleton.h"

namespace jostle::modules {
namespace {

TEST(Base64, round_trips) {
    std::string text;
    for (int k = 0; k < 40; k++) {
        const auto bytes = gltf::from_base64(base64(text));
        ASSERT_TRUE(bytes.has_value()) << k << " bytes";
        EXPECT_EQ(*bytes, bytes_of(text));
        text += static_cast<char>(k * 37);
    }
}

TEST(Base64, rejects_invalid_base64) {
    for (const char* text : {"A", "AAAA*", "AA-A", "A=A="})
        EXPECT_FALSE(gltf::from_base64(text).has_value()) << text;
}

}  // namespace
}  // namespace jostle::modules
