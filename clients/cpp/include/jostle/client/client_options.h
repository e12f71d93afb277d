// SPDX-License-Identifier: MIT
//
// Where a client connects to, who it is, and what it asks for.
#pragma once

#include <cstdint>
#include <string>

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
    // The highest codec of snapshots that it asks for: 2 has two thirds of the bytes of 1 and takes
    // about twice the time to decode.
    std::uint32_t codec = 2;
    // Connects again after a stream that ended, with pauses that grow to 5 s.
    bool reconnect = true;
};

}  // namespace jostle::client
