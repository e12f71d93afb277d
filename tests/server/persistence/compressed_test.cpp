// SPDX-License-Identifier: MIT
#include "persistence/compressed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace jostle::server {
namespace {

using testing::HasSubstr;

std::string noise(std::size_t size) {
    std::mt19937 random(7);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() & 255);
    return bytes;
}

// With another size in its head.
std::string claim(std::string compressed, std::uint64_t size) {
    for (std::size_t k = 0; k < 8; k++) compressed[5 + k] = static_cast<char>(size >> 8 * k & 255);
    return compressed;
}

std::string refusal(std::string_view compressed, std::size_t bytes_max) {
    const auto bytes = decompress(compressed, bytes_max);
    if (bytes.ok()) return "taken";
    EXPECT_EQ(bytes.error().code, ErrorCode::corrupt_data);
    return bytes.error().message;
}

TEST(Compressed, what_comes_back_is_what_was_given) {
    const std::string given[] = {"", "x", std::string(3'000'000, 'x'), noise(300'000)};
    for (const std::string& bytes : given) {
        const auto back = decompress(compress(bytes), bytes.size());
        ASSERT_TRUE(back.ok()) << bytes.size() << ": " << back.error().message;
        EXPECT_TRUE(*back == bytes) << bytes.size();
    }
}

TEST(Compressed, a_million_equal_bytes_take_less_than_a_hundred) {
    EXPECT_LT(compress(std::string(1'000'000, 'x')).size(), 100u);
    EXPECT_LT(compress(noise(1'000'000)).size(), 1'000'100u) << "and noise hardly more than it is";
}

TEST(Compressed, a_bomb_is_refused_by_what_it_says_and_by_what_it_does) {
    const std::string bomb = compress(std::string(100'000'000, '\0'));
    ASSERT_LT(bomb.size(), 20'000u);
    EXPECT_THAT(refusal(bomb, 99'999'999),
                HasSubstr("hold 100000000 bytes, and 99999999 are allowed"));
    EXPECT_THAT(refusal(claim(bomb, 1000), 1000), HasSubstr("frame of zstd at byte 13"))
        << "it says less in its head than in its frame";
    EXPECT_THAT(refusal(claim(compress("x"), std::uint64_t{1} << 62), ~std::size_t{0}),
                HasSubstr("more than"))
        << "no memory is asked for what so few bytes cannot hold";
}

TEST(Compressed, each_damaged_bit_and_each_missing_end_is_seen) {
    const std::string bytes = noise(200) + std::string(200, 'x') + noise(100);
    const std::string compressed = compress(bytes);
    for (std::size_t k = 0; k < compressed.size(); k++) {
        EXPECT_NE(refusal(compressed.substr(0, k), 1000), "taken") << k;
        int refused = 0;
        for (int bit = 0; bit < 8; bit++) {
            std::string damaged = compressed;
            damaged[k] = static_cast<char>(damaged[k] ^ 1 << bit);
            // Some bits of zstd say nothing that matters: then all is as it was.
            const auto opened = decompress(damaged, 1000);
            EXPECT_TRUE(!opened.ok() || *opened == bytes) << "bit " << bit << " of byte " << k;
            refused += !opened.ok();
        }
        EXPECT_GE(refused, 5) << "of 8, at byte " << k;
    }
    EXPECT_THAT(refusal(compressed + "x", 1000), HasSubstr("others follow"));
    EXPECT_THAT(refusal(bytes, 1000), HasSubstr("do not begin with \"jstz\""));
}

TEST(Compressed, bytes_of_a_later_version_say_which) {
    std::string later = compress("x");
    later[4] = 2;
    EXPECT_THAT(refusal(later, 1000), HasSubstr("version 2, and this program reads 1"));
}

}  // namespace
}  // namespace jostle::server
