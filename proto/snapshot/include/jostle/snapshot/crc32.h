// SPDX-License-Identifier: MIT
//
// CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), as zlib and PNG compute it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jostle::wire {

std::uint32_t crc32(std::span<const std::byte> bytes);

// The same in pieces: begin with all ones, go on with each piece, and invert the end. A piece that
// begins with 0 adds to what came before it: state(a then b) = state(a then zeros) ^ state_of_0(b).
inline constexpr std::uint32_t crc32_initial = 0xffffffffu;
// By eight bytes, the lowest first.
std::uint32_t crc32_update(std::uint32_t state, std::uint64_t eight_bytes);
// By so many bytes that are 0, in a few steps. Any thread.
class Crc32Zeros {
public:
    explicit Crc32Zeros(std::size_t bytes);
    std::uint32_t operator()(std::uint32_t state) const {
        return table_[0][state & 0xff] ^ table_[1][state >> 8 & 0xff] ^
               table_[2][state >> 16 & 0xff] ^ table_[3][state >> 24];
    }

private:
    std::array<std::array<std::uint32_t, 256>, 4> table_;
};

}  // namespace jostle::wire
