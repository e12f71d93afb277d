// SPDX-License-Identifier: MIT
//
// Numbers are written with their lowest byte first and read back bit by bit; what is missing reads
// as zeros.
#include "physics/src/foundation/byte_stream.h"

#include <gtest/gtest.h>

#include <limits>

namespace jostle::test {
namespace {
using namespace physics;

enum class Colour : std::uint8_t { red, green = 200 };

TEST(ByteStream, is_little_endian) {
    ByteWriter writer;
    writer.write(std::uint32_t{0x04030201});
    writer.write(std::int16_t{-2});
    writer.write(true);
    writer.write(Colour::green);
    const int expected[] = {1, 2, 3, 4, 0xfe, 0xff, 1, 200};
    ASSERT_EQ(writer.bytes().size(), 8u);
    for (std::size_t k = 0; k < 8; k++)
        EXPECT_EQ(std::to_integer<int>(writer.bytes()[k]), expected[k]) << "byte " << k;
}

// Room is made as it is needed: 100,000 numbers come back in order.
TEST(ByteStream, grows_and_restarts_after_take) {
    ByteWriter writer;
    writer.write(std::uint32_t{0});
    for (std::uint32_t k = 1; k < 100'000; k++) writer.write(k);
    writer.write_at(4, std::uint32_t{77});
    ASSERT_EQ(writer.size(), 400'000u);
    const std::vector<std::byte> bytes = writer.take();
    ASSERT_EQ(bytes.size(), 400'000u);
    ByteReader reader(bytes);
    for (std::uint32_t k = 0; k < 100'000; k++)
        ASSERT_EQ(reader.read_bits<std::uint32_t>(), k == 1 ? 77 : k);
    EXPECT_EQ(writer.size(), 0u);
    writer.write(std::uint8_t{5});
    EXPECT_EQ(writer.take(), std::vector<std::byte>{std::byte{5}});
}

// IEEE 754: 1 is 3f800000 as a float; minus zero and numbers that are none keep their bits.
TEST(ByteStream, keeps_every_bit_of_a_float) {
    EXPECT_EQ(bits_of(1.0f), 0x3f800000u);
    const double values[] = {-0.0, 5e-324, 1.0 / 3, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
    ByteWriter writer;
    for (const double value : values) writer.write(value);
    ByteReader reader(writer.bytes());
    for (const double value : values) EXPECT_EQ(reader.read_bits<double>(), bits_of(value));
    EXPECT_EQ(reader.left(), 0u);
    EXPECT_FALSE(reader.failed());
}

TEST(ByteStream, read_past_the_end_returns_zeros_and_sets_failed) {
    ByteWriter writer;
    writer.write(std::uint8_t{7});
    writer.write(std::uint16_t{0xffff});
    ByteReader reader(writer.bytes());
    EXPECT_EQ(reader.read_bits<std::uint8_t>(), 7);
    EXPECT_EQ(reader.at(), 1u);
    EXPECT_EQ(reader.read_bits<std::uint32_t>(), 0u) << "two bytes are left, not four";
    EXPECT_TRUE(reader.failed());
    EXPECT_EQ(reader.left(), 0u);
    EXPECT_EQ(reader.read_bits<std::uint8_t>(), 0);
    EXPECT_TRUE(reader.failed());
}

}  // namespace
}  // namespace jostle::test
