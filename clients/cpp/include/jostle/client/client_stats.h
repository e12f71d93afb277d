// SPDX-License-Identifier: MIT
//
// What a client has seen so far: counts since it was made, over all its connections.
#pragma once

#include <cstdint>
#include <string>

namespace jostle::client {

struct ClientStats {
    bool connected = false;  // welcomed, and not ended since
    std::uint32_t client_id = 0;
    std::uint64_t snapshots = 0, bytes_received = 0;
    std::uint64_t inputs_sent = 0, inputs_applied = 0, inputs_refused = 0;
    std::uint64_t decode_errors = 0;    // snapshots that did not decode or whose CRC did not match
    std::uint64_t stream_failures = 0;  // ends that nobody asked for
    double rtt_ms = 0;
    std::string last_error;  // the newest failure, for people
};

}  // namespace jostle::client
