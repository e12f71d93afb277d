// SPDX-License-Identifier: MIT
//
// Where a client connects to, who it is, and what it asks for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/client/link_conditioner.h"
#include "jostle/client/security.h"

namespace jostle::client {

struct ClientOptions {
    std::string target = "localhost:50051";  // of the server's gRPC port
    Security security;
    std::string world;              // name or id; empty: the server's first
    std::string ticket;             // from WorldClient::join, when the server asks for one
    std::string name;               // shown to others; at most 32 bytes
    std::uint32_t snapshot_hz = 0;  // snapshots a second that it wants; 0: the world's rate
    bool spectator = false;         // the server refuses its inputs
    bool events = false;            // asks for what happens in the world: Client::take_events()
    // Kinds of channels that it understands (WorldView::channels()); "*": all. What is not named is
    // not sent.
    std::vector<std::string> channels = {};
    // Connects again after a stream that ended, with pauses that grow to 5 s.
    bool reconnect = true;
    // Each input is meant for a tick (InputClock) and waits for it at the server, so that the
    // client can foresee what it does. Costs about a tick of delay.
    bool timed_inputs = false;
    // For tests and demonstrations: a link that is worse than the real one, in both directions, to
    // a millisecond.
    LinkSettings link = {};
};

}  // namespace jostle::client
