// SPDX-License-Identifier: MIT
//
// Checkpoints as they are stored: saved worlds take a quarter of the room so. What comes back is
// what was given, or a reason why not. Any thread, as many at once as like.
//
// Bytes: the magic "jstz", one byte for the version (1), the size of what was given (8 bytes,
// little endian), then one frame of zstd (RFC 8878) with its checksum.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// At zstd's level 1: more effort buys saved worlds little.
std::string compress(std::string_view bytes);

// corrupt_data: it is not of compress(), of a later version, damaged, or says that it holds more
// than bytes_max bytes. Whatever it is, no more memory is taken than about bytes_max, nor more than
// a block of zstd can hold for each 4 bytes given.
Result<std::string> decompress(std::string_view compressed, std::size_t bytes_max);

}  // namespace jostle::server
