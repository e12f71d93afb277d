// SPDX-License-Identifier: MIT
#include "server/auth/base64url.h"

#include <gtest/gtest.h>

#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

TEST(Base64url, round_trips_every_length) {
    std::string bytes;
    for (int i = 0; i < 300; ++i) {
        EXPECT_EQ(from_base64url(test::to_base64url(bytes)), bytes) << i;
        bytes += static_cast<char>(i * 37);
    }
    EXPECT_EQ(from_base64url("-_8"), "\xfb\xff");
}

TEST(Base64url, rejects_non_canonical_encodings) {
    EXPECT_TRUE(from_base64url("TQ"));
    for (const char* text : {"TQ==",  // padding
                             "+/8",   // standard alphabet
                             "T Q",   // white space
                             "TQ\n",  //
                             "T",     // 6 bits
                             "TR",    // nonzero unused bits
                             "TWF\x80"}) {
        EXPECT_FALSE(from_base64url(text)) << text;
    }
    EXPECT_FALSE(from_base64url(std::string_view("TQ\0A", 4)));
}

}  // namespace
}  // namespace jostle::server
