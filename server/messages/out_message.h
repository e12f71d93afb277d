// SPDX-License-Identifier: MIT
//
// One ServerMessage on its way out, in pieces: the bytes of this client alone and those that many
// clients get. Protobuf lets the fields of a message stand in any order and be concatenated, so the
// pieces sent one after the other are the message, and the big ones are never copied.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "server/replication/snapshot_cache.h"

namespace jostle::server {

struct OutMessage {
    std::string header;                // first on the wire
    SharedBytes shared;                // then this; null: nothing
    std::vector<SharedBytes> cells{};  // then these; none of them null

    std::size_t size() const {
        std::size_t bytes = header.size() + (shared ? shared->size() : 0);
        for (const SharedBytes& cell : cells) bytes += cell->size();
        return bytes;
    }
    // For who does not send pieces.
    std::string concatenated() const {
        std::string bytes = header + (shared ? *shared : "");
        for (const SharedBytes& cell : cells) bytes += *cell;
        return bytes;
    }
};

}  // namespace jostle::server
