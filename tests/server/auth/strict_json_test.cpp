// SPDX-License-Identifier: MIT
#include "server/auth/strict_json.h"

#include <gtest/gtest.h>

#include <string>

namespace jostle::server {
namespace {

std::string strict_json_fault(const std::string& text) {
    const auto read = parse_strict_json(text, 4);
    return read.ok() ? "" : read.error().message;
}

TEST(StrictJson, parses_one_value) {
    const auto read = parse_strict_json(R"({"a": [1, {"b": "c"}], "d": {"a": null}})", 4);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ((*read)["a"][1]["b"], "c");
}

TEST(StrictJson, rejects_duplicate_keys_at_any_depth) {
    EXPECT_EQ(strict_json_fault(R"({"a": 1, "b": 2, "a": 3})"), "an object has a duplicate key");
    EXPECT_EQ(strict_json_fault(R"([{"x": {"a": 1, "\u0061": 2}}])"),
              "an object has a duplicate key")
        << "escapes are another spelling of the same key";
    EXPECT_EQ(strict_json_fault(R"({"a": {"a": {"a": 1}}, "b": {"a": 1}})"), "");
}

TEST(StrictJson, rejects_excessive_nesting) {
    EXPECT_EQ(strict_json_fault("[[[[1]]]]"), "");
    EXPECT_EQ(strict_json_fault("[[[[[1]]]]]"), "it is nested too deeply");
    EXPECT_EQ(strict_json_fault(std::string(100000, '[')), "it is nested too deeply");
}

TEST(StrictJson, rejects_byte_order_marks_and_zero_bytes) {
    EXPECT_EQ(strict_json_fault("\xef\xbb\xbf{}"), "it begins with a byte order mark");
    EXPECT_EQ(strict_json_fault(std::string("{}\0", 3)), "it has a zero byte");
    EXPECT_EQ(strict_json_fault(std::string("{}\0{\"a\": 1}", 11)), "it has a zero byte");
    EXPECT_EQ(strict_json_fault(R"({"a": "\ufeff"})"), "") << "within a string it is a character";
}

TEST(StrictJson, rejects_malformed_json_and_trailing_data) {
    for (const char* text : {"", "{", "{} {}", "{\"a\": 1,}", "'a'", "{\"a\": NaN}", "\"\xff\"",
                             "{\"a\": 1} x", "/* no */ {}"}) {
        EXPECT_EQ(strict_json_fault(text), "it is not valid JSON") << text;
    }
}

}  // namespace
}  // namespace jostle::server
