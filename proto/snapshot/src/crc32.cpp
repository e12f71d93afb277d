// SPDX-License-Identifier: MIT
//
// Eight bytes per iteration with eight tables (Kounavis and Berry, "Novel Table Lookup-Based
// Algorithms for High-Performance CRC Generation", 2008): both sides compute the CRC of every
// entity of every frame.
#include "jostle/snapshot/crc32.h"

#include <array>

namespace jostle::snapshot {
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

std::uint32_t crc32_update(std::uint32_t state, std::uint64_t eight_bytes) {
    const auto low = state ^ static_cast<std::uint32_t>(eight_bytes);
    const auto high = static_cast<std::uint32_t>(eight_bytes >> 32);
    return tables[7][low & 0xff] ^ tables[6][low >> 8 & 0xff] ^ tables[5][low >> 16 & 0xff] ^
           tables[4][low >> 24] ^ tables[3][high & 0xff] ^ tables[2][high >> 8 & 0xff] ^
           tables[1][high >> 16 & 0xff] ^ tables[0][high >> 24];
}

std::uint32_t crc32(std::span<const std::byte> bytes) {
    std::uint32_t crc = crc32_initial;
    std::size_t at = 0;
    const auto byte = [&](std::size_t k) { return std::to_integer<std::uint64_t>(bytes[at + k]); };
    for (; at + 8 <= bytes.size(); at += 8)
        crc = crc32_update(crc, byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24 |
                                    byte(4) << 32 | byte(5) << 40 | byte(6) << 48 | byte(7) << 56);
    for (; at < bytes.size(); at++) crc = tables[0][(crc ^ byte(0)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

// The effect of zero bytes on a state is linear in its bits.
Crc32Zeros::Crc32Zeros(std::size_t bytes) {
    std::array<std::uint32_t, 32> of_bit{};
    for (std::size_t bit = 0; bit < of_bit.size(); bit++) {
        std::uint32_t state = 1u << bit;
        for (std::size_t k = 0; k < bytes; k++) state = tables[0][state & 0xff] ^ (state >> 8);
        of_bit[bit] = state;
    }
    for (std::size_t byte = 0; byte < table_.size(); byte++)
        for (std::size_t value = 0; value < 256; value++) {
            std::uint32_t sum = 0;
            for (std::size_t bit = 0; bit < 8; bit++)
                if ((value >> bit & 1) != 0) sum ^= of_bit[8 * byte + bit];
            table_[byte][value] = sum;
        }
}

}  // namespace jostle::snapshot
