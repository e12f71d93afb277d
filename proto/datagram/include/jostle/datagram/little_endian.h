// SPDX-License-Identifier: MIT
//
// Little-endian integers in datagrams. Pure functions; any thread.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace jostle::datagram {

template <std::unsigned_integral Number>
void put_number(std::string& to, Number number) {
    for (std::size_t k = 0; k < sizeof number; k++)
        to += static_cast<char>(static_cast<std::uint8_t>(number >> (8 * k)));
}

/// Reads an integer at `at`. The caller guarantees that the bytes exist.
template <std::unsigned_integral Number>
Number number_at(std::string_view bytes, std::size_t offset) {
    Number number = 0;
    for (std::size_t k = 0; k < sizeof number; k++) {
        const auto byte = static_cast<Number>(static_cast<std::uint8_t>(bytes[offset + k]));
        number = static_cast<Number>(number | static_cast<Number>(byte << (8 * k)));
    }
    return number;
}

}  // namespace jostle::datagram
