// SPDX-License-Identifier: MIT
#include "server/config/origin.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(Origin, ignores_case_and_default_ports) {
    const auto page = parse_origin("https://play.example.org");
    EXPECT_EQ(page, (Origin{"https", "play.example.org", 443}));
    for (const char* same :
         {"https://play.example.org:443", "HTTPS://Play.Example.ORG", "https://play.example.org:"})
        EXPECT_EQ(parse_origin(same), page) << same;
    for (const char* other : {"http://play.example.org", "https://play.example.org:8443",
                              "https://example.org", "http://play.example.org:443"})
        EXPECT_NE(parse_origin(other), page) << other;
    EXPECT_EQ(parse_origin("http://[::1]"), (Origin{"http", "[::1]", 80}));
    EXPECT_EQ(parse_origin("http://[::1]:8080"), (Origin{"http", "[::1]", 8080}));
    EXPECT_EQ(parse_origin("capacitor://localhost"), (Origin{"capacitor", "localhost", 0}));
}

TEST(Origin, rejects_texts_that_are_no_origin) {
    for (const char* text :
         {"", "null", "*", "play.example.org", "https://", "https://:443", "https://a/",
          "https://a?b", "https://user@a", "https://a:65536", "https://a:0", "https://a:80x",
          "https://[::1", "1a://b", "://a", "https://a b"})
        EXPECT_FALSE(parse_origin(text)) << text;
}

}  // namespace
}  // namespace jostle::server
