// SPDX-License-Identifier: MIT
#include "server/http/percent_decode.h"

#include <gtest/gtest.h>

namespace jostle::server {

TEST(PercentDecode, decodes_escapes_and_rejects_malformed_ones) {
    EXPECT_EQ(percent_decode("a%20b%2Fc"), "a b/c");
    EXPECT_EQ(percent_decode("a+b"), "a+b");
    for (const char* bad : {"%", "%2", "%zz", "a%2"}) EXPECT_FALSE(percent_decode(bad)) << bad;
}

TEST(PercentDecode, finds_query_fields_by_exact_name) {
    const char* target = "/debug/profile?seconds=5&world=my%20arena&x&empty=";
    EXPECT_EQ(query_field(target, "world"), "my arena");
    EXPECT_EQ(query_field(target, "seconds"), "5");
    EXPECT_EQ(query_field(target, "empty"), "");
    EXPECT_FALSE(query_field(target, "orld"));
    EXPECT_FALSE(query_field(target, "x"));
    EXPECT_FALSE(query_field("/debug/profile", "world"));
    EXPECT_FALSE(query_field("/p?world=%z", "world"));
}

}  // namespace jostle::server
