// SPDX-License-Identifier: MIT
//
// An outgoing ServerMessage in pieces: the bytes for one client, and shared bytes for many.
// Protobuf allows fields in any order and the concatenation of messages, so the pieces in sequence
// form the message, and the large ones are never copied.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "server/replication/snapshot_cache.h"

namespace jostle::server {

struct OutMessage {
    std::string header;                        // first
    SharedBytes shared;                        // second; null: nothing
    std::vector<SharedBytes> shared_fields{};  // last; none of them null

    std::size_t size() const {
        std::size_t bytes = header.size() + (shared ? shared->size() : 0);
        for (const SharedBytes& field : shared_fields) bytes += field->size();
        return bytes;
    }
    // For transports that need one contiguous buffer.
    std::string concatenated() const {
        std::string bytes = header + (shared ? *shared : "");
        for (const SharedBytes& field : shared_fields) bytes += *field;
        return bytes;
    }
};

}  // namespace jostle::server
