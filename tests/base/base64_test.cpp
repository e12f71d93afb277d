// SPDX-License-Identifier: MIT
#include "jostle/base/base64.h"

#include <gtest/gtest.h>

namespace jostle {
namespace {

std::string encode(const std::string& bytes, Base64 alphabet) {
    return encode_base64(std::as_bytes(std::span(bytes)), alphabet);
}

std::string error_of(std::string_view text, Base64 alphabet) {
    const auto bytes = decode_base64(text, alphabet);
    return bytes.ok() ? "" : bytes.error().message;
}

TEST(Base64, round_trips_every_length) {
    for (const Base64 alphabet : {Base64::standard, Base64::url}) {
        std::string bytes;
        for (int i = 0; i < 300; ++i) {
            EXPECT_EQ(decode_base64<std::string>(encode(bytes, alphabet), alphabet).value(), bytes);
            bytes += static_cast<char>(i * 37);
        }
    }
}

// The test vectors of RFC 4648, section 10.
TEST(Base64, encodes_the_rfc_test_vectors) {
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) EXPECT_EQ(encode(bytes, Base64::standard), text);
    EXPECT_EQ(encode("\xfb\xff", Base64::standard), "+/8=");
    EXPECT_EQ(encode("\xfb\xff", Base64::url), "-_8");
}

TEST(Base64, decodes_bytes_and_text) {
    EXPECT_EQ(decode_base64("+/8=").value(), (std::vector{std::byte{0xfb}, std::byte{0xff}}));
    EXPECT_EQ(decode_base64<std::string>("-_8", Base64::url).value(), "\xfb\xff");
    EXPECT_EQ(decode_base64<std::string>("TQ").value(), "M");  // padding is optional
}

TEST(Base64, rejects_non_canonical_encodings) {
    for (const char* text : {"T",      // 6 bits
                             "TR==",   // nonzero unused bits
                             "TQ=",    // incomplete padding
                             "TQ===",  //
                             "TWFu=",  // padding of a complete group
                             "====",   //
                             "T=Q=",   // padding between digits
                             "-_8=",   // alphabet of URLs
                             "T Q=", "TQ\n", "TWF\x80"})
        EXPECT_FALSE(decode_base64(text).ok()) << text;
    for (const char* text : {"TQ==",  // padding
                             "+/8",   // standard alphabet
                             "T Q", "TQ\n", "T", "TR", "TWF\x80"})
        EXPECT_FALSE(decode_base64(text, Base64::url).ok()) << text;
    EXPECT_FALSE(decode_base64(std::string_view("TQ\0A", 4), Base64::url).ok());
}

TEST(Base64, errors_state_the_reason) {
    EXPECT_EQ(error_of("TQ=A", Base64::standard), "character 3 is not a digit of base64");
    EXPECT_EQ(error_of("TQ/A", Base64::url), "character 3 is not a digit of base64url");
    EXPECT_EQ(error_of("TWFuT", Base64::url),
              "the last group has one digit of base64; must be 2, 3 or 4");
    EXPECT_EQ(error_of("TR", Base64::url), "the unused bits of the last digit are not zero");
}

}  // namespace
}  // namespace jostle
