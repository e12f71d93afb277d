// SPDX-License-Identifier: MIT
//
// Base64 (RFC 4648) in the standard and in the URL-safe alphabet. Decoding is strict: apart from
// the optional padding of the standard alphabet, each sequence of bytes has one encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"

namespace jostle {

enum class Base64 {
    standard,  ///< + and / (RFC 4648, section 4): encoded with padding, decoded with or without
    url,       ///< - and _ (RFC 4648, section 5): never padded, as in tokens (RFC 7515)
};

/// Returns the encoded bytes.
inline std::string encode_base64(std::span<const std::byte> bytes,
                                 Base64 alphabet = Base64::standard) {
    std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
    digits += alphabet == Base64::url ? "-_" : "+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    std::uint32_t pending = 0;  // bits that are not written yet
    int count = 0;              // number of pending bits
    for (const std::byte byte : bytes) {
        pending = (pending << 8 | std::to_integer<std::uint32_t>(byte)) & 0xfff;
        for (count += 8; count >= 6; count -= 6) text += digits[pending >> (count - 6) & 63];
    }
    if (count > 0) text += digits[pending << (6 - count) & 63];
    while (alphabet == Base64::standard && text.size() % 4 != 0) text += '=';
    return text;
}

/// Returns the decoded bytes, as std::vector<std::byte> or std::string. Rejects digits of the other
/// alphabet, white space, incomplete groups and padding, and nonzero unused bits.
template <class Bytes = std::vector<std::byte>>
Result<Bytes> decode_base64(std::string_view text, Base64 alphabet = Base64::standard) {
    const auto value_of = [alphabet](char digit) {
        if (digit >= 'A' && digit <= 'Z') return digit - 'A';
        if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
        if (digit >= '0' && digit <= '9') return digit - '0' + 52;
        if (digit == (alphabet == Base64::url ? '-' : '+')) return 62;
        return digit == (alphabet == Base64::url ? '_' : '/') ? 63 : -1;
    };
    std::string_view digits = text;
    if (alphabet == Base64::standard && text.size() % 4 == 0)
        for (int k = 0; k < 2 && digits.ends_with('='); k++) digits.remove_suffix(1);
    if (digits.size() % 4 == 1)
        return invalid_argument("the last group has one digit of base64; must be 2, 3 or 4");
    Bytes bytes;
    bytes.reserve(digits.size() * 3 / 4);
    std::uint32_t pending = 0;  // bits that are not written yet
    int count = 0;              // number of pending bits
    for (std::size_t k = 0; k < digits.size(); k++) {
        const int value = value_of(digits[k]);
        if (value < 0)
            return invalid_argument("character " + std::to_string(k + 1) + " is not a digit of " +
                                    (alphabet == Base64::url ? "base64url" : "base64"));
        pending = (pending << 6 | static_cast<std::uint32_t>(value)) & 0xffff;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<typename Bytes::value_type>(pending >> count & 0xff));
    }
    if ((pending & ((1u << count) - 1)) != 0)
        return invalid_argument("the unused bits of the last digit are not zero");
    return bytes;
}

}  // namespace jostle
