// SPDX-License-Identifier: MIT
//
// CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), as zlib and PNG compute it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace jostle::wire {

std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace jostle::wire
