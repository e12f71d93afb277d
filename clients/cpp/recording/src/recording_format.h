// SPDX-License-Identifier: MIT
//
// Layout of a recording (proto/WIRE.md, "Recordings"), shared by writer and reader. All numbers are
// little-endian.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "jostle/snapshot/crc32.h"

namespace jostle::client::recording {

inline constexpr std::string_view magic = "JREC", end_magic = "JEND";
inline constexpr std::uint32_t version = 1;
inline constexpr std::uint64_t header_bytes = 16;
inline constexpr std::uint64_t record_header_bytes = 16;  // of a record, before its message
inline constexpr std::uint64_t crc_from = 8;              // a CRC covers the rest of its record
inline constexpr std::uint32_t message_bytes_max = 1u << 26;
inline constexpr std::uint64_t index_head_bytes = 8, entry_bytes = 16, trailer_bytes = 16;

template <std::unsigned_integral Number>
void put(std::string& bytes, Number value) {
    for (std::size_t k = 0; k < sizeof value; k++)
        bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

// The caller guarantees that the bytes exist.
template <std::unsigned_integral Number>
Number get(std::string_view bytes, std::size_t at) {
    Number value = 0;
    for (std::size_t k = 0; k < sizeof value; k++)
        value |= static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(bytes[at + k]))
                                     << (8 * k));
    return value;
}

inline std::uint32_t crc_of(std::string_view bytes) {
    return snapshot::crc32(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

}  // namespace jostle::client::recording
