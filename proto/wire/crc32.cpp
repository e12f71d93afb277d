// SPDX-License-Identifier: MIT
//
// Eight bytes a round with eight tables (Kounavis and Berry, "Novel Table Lookup-Based Algorithms
// for High-Performance CRC Generation", 2008): the CRC runs over every entity of every frame on
// both sides.
#include "wire/crc32.h"

#include <array>

namespace jostle::wire {
namespace {

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
    Tables tables{};
    for (std::uint32_t i = 0; i < 256; i++) {
        std::uint32_t c = i;
        for (int k = 0; k < 8; k++) c = (c & 1) != 0 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
        tables[0][i] = c;
    }
    for (std::size_t t = 1; t < 8; t++)
        for (std::size_t i = 0; i < 256; i++)
            tables[t][i] = (tables[t - 1][i] >> 8) ^ tables[0][tables[t - 1][i] & 0xff];
    return tables;
}

constexpr Tables tables = make_tables();

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xffffffffu;
    std::size_t at = 0;
    const auto byte = [&](std::size_t k) { return std::to_integer<std::uint32_t>(bytes[at + k]); };
    for (; at + 8 <= bytes.size(); at += 8) {
        const std::uint32_t low = crc ^ (byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24);
        crc = tables[7][low & 0xff] ^ tables[6][low >> 8 & 0xff] ^ tables[5][low >> 16 & 0xff] ^
              tables[4][low >> 24] ^ tables[3][byte(4)] ^ tables[2][byte(5)] ^ tables[1][byte(6)] ^
              tables[0][byte(7)];
    }
    for (; at < bytes.size(); at++) crc = tables[0][(crc ^ byte(0)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

}  // namespace jostle::wire
