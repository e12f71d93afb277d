// SPDX-License-Identifier: MIT
//
// One ServerMessage on its way out, in at most two pieces: the bytes of this client alone and the
// bytes that many clients get. Protobuf lets the fields of a message stand in any order and be
// concatenated, so the two pieces sent one after the other are the message, and the big one is
// never copied.
#pragma once

#include <cstddef>
#include <string>

#include "replication/snapshot_cache.h"

namespace jostle::server {

struct OutMessage {
    std::string head;    // first on the wire
    SharedBytes shared;  // then this; null: nothing

    std::size_t size() const { return head.size() + (shared ? shared->size() : 0); }
};

}  // namespace jostle::server
