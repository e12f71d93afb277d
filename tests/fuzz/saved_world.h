// SPDX-License-Identifier: MIT
//
// The header of a saved world, made right again after the bytes were changed, as a forger would.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "physics/src/serialization/checksum.h"

namespace jostle::fuzz {

inline constexpr std::size_t saved_header_bytes = 28;  // mark 8, version 4, length 8, checksum 8

// Writes length and checksum; bytes too few for a header stay as they are.
inline void update_saved_header(std::span<std::byte> saved) {
    if (saved.size() < saved_header_bytes) return;
    const std::span<const std::byte> rest = saved.subspan(saved_header_bytes);
    const std::uint64_t length = rest.size();
    std::uint32_t version = 0;
    std::memcpy(&version, saved.data() + 8, 4);
    const std::uint64_t checksum = physics::checksum_of_version(version, rest);
    std::memcpy(saved.data() + 12, &length, 8);
    std::memcpy(saved.data() + 20, &checksum, 8);
}

}  // namespace jostle::fuzz
