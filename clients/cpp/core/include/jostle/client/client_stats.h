// SPDX-License-Identifier: MIT
//
// Statistics of a client: totals since it was created, over all its connections.
#pragma once

#include <cstdint>
#include <string>

namespace jostle::client {

/// Statistics of a Client.
struct ClientStats {
    bool connected = false;  ///< a Welcome was received and the stream is open
    std::uint32_t client_id = 0;
    std::uint64_t snapshots = 0;       ///< decoded snapshots
    std::uint64_t bytes_received = 0;  ///< of messages of all kinds
    std::uint64_t inputs_sent = 0, inputs_applied = 0, inputs_refused = 0;
    /// Malformed messages, and snapshots that did not decode or whose CRC did not match. Errors
    /// while a requested keyframe is in transit are not counted.
    std::uint64_t decode_errors = 0;
    std::uint64_t resumed = 0;          ///< streams that resumed a session
    std::uint64_t stream_failures = 0;  ///< streams that ended without a request of this client
    bool datagrams = false;             ///< datagrams currently get through
    /// snapshots received as datagrams; included in `snapshots`
    std::uint64_t datagram_snapshots = 0;
    std::uint64_t stale_snapshots = 0;    ///< discarded because a newer one had arrived
    std::uint64_t messages_received = 0;  ///< user messages
    /// User messages that the server no longer stored when this client was ready to receive them.
    std::uint64_t messages_missed = 0;
    double rtt_ms = 0;           ///< round-trip time, ms; see ClockSync
    double input_margin_ms = 0;  ///< see InputClock; for inputs without a tick: their waiting time
    std::string last_error;      ///< the newest failure or notice of the server, as text
};

}  // namespace jostle::client
