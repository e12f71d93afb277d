// SPDX-License-Identifier: MIT
#include "server/storage/compression.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/random.h"

namespace jostle::server {
namespace {

using test::error_of;

TEST(Compression, round_trips_and_compresses_repetition) {
    test::Random random(3);
    std::string noise;
    for (int k = 0; k < 5000; k++) noise += static_cast<char>(random.below(256));
    for (const std::string& bytes : {std::string(), std::string("a"), noise, noise + noise}) {
        const Result<std::string> again = decompress(compress(bytes), bytes.size());
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(*again, bytes);
    }
    EXPECT_LT(compress(std::string(1 << 20, 'x')).size(), 1000u);
}

TEST(Compression, rejects_decompression_bombs_before_allocating) {
    const std::string bomb = compress(std::string(64 << 20, 'x'));
    EXPECT_LT(bomb.size(), 10000u);
    EXPECT_EQ(error_of(decompress(bomb, 1 << 20)).message,
              "compressed data: 67108864 bytes when decompressed; at most 1048576 are allowed");
}

TEST(Compression, detects_any_changed_byte) {
    test::Random random(4);
    std::string bytes;
    for (int k = 0; k < 400; k++) bytes += static_cast<char>('a' + random.below(9));
    const std::string packed = compress(bytes);
    for (std::size_t at = 0; at < packed.size(); at++) {
        std::string changed = packed;
        changed[at] = static_cast<char>(changed[at] ^ (1 << random.below(8)));
        const Result<std::string> got = decompress(changed, 1 << 16);
        EXPECT_TRUE(!got.ok() || *got == bytes) << "byte " << at;
        EXPECT_FALSE(decompress(packed.substr(0, at), 1 << 16).ok());
    }
    EXPECT_FALSE(decompress(packed + "x", 1 << 16).ok());
}

}  // namespace
}  // namespace jostle::server
