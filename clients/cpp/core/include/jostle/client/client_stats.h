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
    std::uint64_t snapshots = 0;       // that were decoded
    std::uint64_t bytes_received = 0;  // of messages of all kinds
    std::uint64_t inputs_sent = 0, inputs_applied = 0, inputs_refused = 0;
    // Messages that were none, and snapshots that did not decode or whose CRC did not match. Those
    // that follow while a keyframe is on its way are not counted.
    std::uint64_t decode_errors = 0;
    std::uint64_t resumed = 0;             // streams in which it was the client that it was before
    std::uint64_t stream_failures = 0;     // streams that ended though nobody here wanted it
    bool datagrams = false;                // they get through now
    std::uint64_t datagram_snapshots = 0;  // that came so, of `snapshots`
    std::uint64_t stale_snapshots = 0;     // that a newer one had overtaken: left out
    double rtt_ms = 0;                     // see ClockSync
    double input_margin_ms = 0;  // see InputClock; of inputs that name no tick: their wait
    std::string last_error;      // the newest failure or notice of the server, for people
};

}  // namespace jostle::client
