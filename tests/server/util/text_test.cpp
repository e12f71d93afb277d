// SPDX-License-Identifier: MIT
#include "server/util/text.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(Text, escapes_newlines) {
    EXPECT_EQ(printable("eve\n2026-01-01 error the moon fell\x1b[2J", 200),
              "eve\\n2026-01-01 error the moon fell\\x1b[2J");
    EXPECT_EQ(in_quotes("a\" joined \"b"), "\"a\\\" joined \\\"b\"");
}

TEST(Text, escapes_invalid_utf8_only) {
    EXPECT_EQ(printable("Jürgen \xff \xc0\xaf \xed\xa0\x80 ok", 200),
              "Jürgen \\xff \\xc0\\xaf \\xed\\xa0\\x80 ok");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m",
                        200),
              "\\xc2\\x9b31m")
        << "an 8-bit control character must be escaped";
    EXPECT_EQ(printable("a\u2028b\u202e", 200), "a\\xe2\\x80\\xa8b\\xe2\\x80\\xae")
        << "a line separator and a direction override must be escaped";
    EXPECT_EQ(printable("C:\\temp", 200), "C:\\\\temp");
}

TEST(Text, finds_control_characters) {
    for (const char* text : {"", "anna", "Jürgen", "你好", "C:\\temp", "a b"})
        EXPECT_FALSE(has_control_character(text)) << text;
    for (const char* text :
         {"a\n", "\x7f", "\x1b[2J", "a\u0085", "a\u2028", "\u202eb", "\u2066", "\ufeffa", "\xff"})
        EXPECT_TRUE(has_control_character(text)) << printable(text, 200);
    EXPECT_TRUE(has_control_character(std::string_view("\0", 1)));
}

TEST(Text, truncates_at_character_boundaries) {
    EXPECT_EQ(clip_utf8("grün", 3), "gr") << "3 bytes would end within a character";
    EXPECT_EQ(clip_utf8("grün", 4), "grü");
    EXPECT_EQ(clip_utf8("\xf0\x9f\x98\x80!", 3), "");
    EXPECT_EQ(clip_utf8("abc", 10), "abc");
    EXPECT_EQ(printable("aaa\n", 4), "aaa") << "an escape sequence must not be truncated";
}

}  // namespace
}  // namespace jostle::server
