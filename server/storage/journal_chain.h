// SPDX-License-Identifier: MIT
//
// Each entry of a journal names all that came before it: what is missing, changed or in another
// order is seen.
#pragma once

#include <span>
#include <string_view>

#include "server/storage/storage_types.h"

namespace jostle::server {

using Digest = Chain;

// SHA-256 of the pieces, each with its length before it, so that they cannot run into each other.
Digest digest_of(std::span<const std::string_view> pieces);
// Of an entry with that data after `before`; that of an empty journal is all zeros.
Chain next_chain(const Chain& before, std::string_view data);

}  // namespace jostle::server
