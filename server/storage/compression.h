// SPDX-License-Identifier: MIT
//
// Compression with zstd (RFC 8878), which is fast enough for a journal and reduces a checkpoint to
// a third. The data includes a checksum. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// Compresses all pieces as one sequence.
std::string compress(std::span<const std::string_view> pieces);
inline std::string compress(std::string_view bytes) {
    return compress(std::span(&bytes, 1));
}
// corrupt_data: not compressed by compress(), altered, or larger than `bytes_max` when
// decompressed. Allocates at most `bytes_max`.
Result<std::string> decompress(std::string_view packed, std::size_t bytes_max);

}  // namespace jostle::server
