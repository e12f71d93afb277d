// SPDX-License-Identifier: MIT
//
// Frames of HTTP/2 (RFC 9113, sections 4.1 and 6): the headers that the gRPC port inspects and that
// jostle-load reads and writes. Payloads are the business of the caller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jostle::http2 {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::string_view preface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";
/// Maximum payload of a frame without SETTINGS_MAX_FRAME_SIZE, bytes. No side raises it.
inline constexpr std::uint32_t frame_bytes_max = 16'384;
/// Initial flow control window without SETTINGS_INITIAL_WINDOW_SIZE, and its maximum, bytes.
inline constexpr std::uint32_t default_window = 65'535, window_max = 0x7fff'ffff;

/// Peers may send types without an enumerator.
enum class FrameType : std::uint8_t {
    data = 0,
    headers = 1,
    priority = 2,
    rst_stream = 3,
    settings = 4,
    push_promise = 5,
    ping = 6,
    goaway = 7,
    window_update = 8,
    continuation = 9,
};

/// Flags; their meaning depends on the type.
namespace flags {
inline constexpr std::uint8_t acknowledged = 1, end_stream = 1, end_headers = 4, padded = 8;
}

enum class Setting : std::uint16_t { enable_push = 2, initial_window = 4 };
inline constexpr std::size_t setting_bytes = 6;

struct FrameHeader {
    std::uint32_t length = 0;  // of the payload, bytes, 24 bits
    FrameType type = {};
    std::uint8_t flags = 0;
    std::uint32_t stream = 0;  // 31 bits; 0: the connection

    bool has(std::uint8_t flag) const { return (flags & flag) != 0; }
};
inline constexpr std::size_t frame_header_bytes = 9;

/// Reads an unsigned number of at most 4 bytes.
inline std::uint32_t big_endian(Bytes bytes) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes) value = value << 8 | byte;
    return value;
}

/// Appends the low `bytes` bytes of a number.
inline void put_big_endian(std::string& out, std::uint64_t value, unsigned bytes) {
    for (unsigned k = bytes; k-- > 0;) out.push_back(static_cast<char>(value >> (8 * k)));
}

inline FrameHeader read_frame_header(std::span<const std::uint8_t, frame_header_bytes> bytes) {
    return {.length = big_endian(bytes.first<3>()),
            .type = FrameType{bytes[3]},
            .flags = bytes[4],
            .stream = big_endian(bytes.subspan<5, 4>()) & 0x7fff'ffff};
}

inline void put_frame_header(std::string& out, const FrameHeader& header) {
    put_big_endian(out, header.length, 3);
    out.push_back(static_cast<char>(header.type));
    out.push_back(static_cast<char>(header.flags));
    put_big_endian(out, header.stream, 4);
}

/// Appends one entry of the payload of a SETTINGS frame.
inline void put_setting(std::string& out, Setting setting, std::uint32_t value) {
    put_big_endian(out, static_cast<std::uint16_t>(setting), 2);
    put_big_endian(out, value, 4);
}

}  // namespace jostle::http2
