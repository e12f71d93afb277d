// SPDX-License-Identifier: MIT
//
// The header of a saved world, made right again after the bytes were changed, as a forger would.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "foundation/hash.h"

namespace jostle::fuzz {

inline constexpr std::size_t saved_header_bytes = 28;  // mark 8, version 4, length 8, checksum 8

// Writes length and checksum; bytes too few for a header stay as they are.
inline void restamp(std::span<std::byte> saved) {
    if (saved.size() < saved_header_bytes) return;
    const std::span<const std::byte> rest = saved.subspan(saved_header_bytes);
    const std::uint64_t length = rest.size();
    physics::Hasher hasher;
    hasher.add(length);
    for (std::size_t at = 0; at < rest.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, rest.data() + at, std::min<std::size_t>(8, rest.size() - at));
        hasher.add(word);
    }
    std::memcpy(saved.data() + 12, &length, 8);
    std::memcpy(saved.data() + 20, &hasher.value, 8);
}

}  // namespace jostle::fuzz
