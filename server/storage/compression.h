// SPDX-License-Identifier: MIT
//
// Bytes packed by zstd (RFC 8878), which is fast enough for a journal and takes a third of a
// checkpoint. A checksum goes with them. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// All pieces, one after the other, as one.
std::string compress(std::span<const std::string_view> pieces);
inline std::string compress(std::string_view bytes) {
    return compress(std::span(&bytes, 1));
}
// corrupt_data: they were not packed so, were changed, or are more than `bytes_max` unpacked. No
// more memory is taken than that.
Result<std::string> decompress(std::string_view packed, std::size_t bytes_max);

}  // namespace jostle::server
