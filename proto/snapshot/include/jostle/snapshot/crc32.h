// SPDX-License-Identifier: MIT
//
// CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), as in zlib and PNG.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jostle::snapshot {

std::uint32_t crc32(std::span<const std::byte> bytes);

/// Incremental computation: start with all ones, update with each piece, and invert the result. A
/// piece processed from state 0 is additive: state(a then b) = state(a then zeros) ^ state_of_0(b).
inline constexpr std::uint32_t crc32_initial = 0xffffffffu;
/// Updates the state with eight bytes, lowest byte first.
std::uint32_t crc32_update(std::uint32_t state, std::uint64_t eight_bytes);
/// Advances a state over a fixed number of zero bytes in a few operations. Any thread.
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

}  // namespace jostle::snapshot
