// SPDX-License-Identifier: MIT
//
// Whom a client connects to, as who, and what it asks for.
#pragma once

#include <cstdint>
#include <string>

namespace jostle::client {

struct ClientOptions {
    std::string target = "localhost:50051";
    std::string world;              // name or id; empty: the first
    std::string ticket;             // from WorldClient::join, when the server asks for one
    std::string name;               // at most 32 bytes
    std::uint32_t snapshot_hz = 0;  // 0: the world's rate
    bool spectator = false;
    bool events = false;    // asks for what happens in the world: see take_events()
    bool reconnect = true;  // after a lost connection, with growing pauses up to 5 s
};

}  // namespace jostle::client
