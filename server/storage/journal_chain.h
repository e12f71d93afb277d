// SPDX-License-Identifier: MIT
//
// A hash chain over the journal: each entry includes the hash of all earlier ones, so that missing,
// altered and reordered entries are detected.
#pragma once

#include <span>
#include <string_view>

#include "server/storage/storage_types.h"

namespace jostle::server {

using Digest = Chain;
inline std::string_view view_of(const Digest& digest) {
    return {reinterpret_cast<const char*>(digest.data()), digest.size()};
}

// SHA-256 of the pieces, each prefixed with its length, so that different splits have different
// digests.
Digest digest_of(std::span<const std::string_view> pieces);
// The chain value of an entry with `data` after `previous`; an empty journal has all zeros.
Chain next_chain(const Chain& previous, std::string_view data);

}  // namespace jostle::server
