// SPDX-License-Identifier: MIT
//
// The client as its transport knows it, and the world as the authorizer knows it.
#pragma once

#include <functional>
#include <string>

#include "server/auth/authorizer.h"
#include "server/limits/overload_control.h"
#include "server/world/world_host.h"

namespace jostle::server {

struct Peer {
    std::string name;                   // for the log: "grpc:192.0.2.7:4711"
    std::string address;                // "192.0.2.7"
    std::string call;                   // its row in the access table
    Result<Identity> who = Identity{};  // an error: its credentials are invalid
    // Called on any thread when a datagram arrived and the session should call take_datagrams()
    // soon. Empty: the transport does not support datagrams.
    std::function<void()> wake = {};
    // Of the thread that serves the client; null: it is never overloaded. Outlives the session.
    OverloadControl* overload = nullptr;
};

// Refers to strings of the host.
inline WorldTarget world_target(const WorldHost& host) {
    return {host.id(), host.name(), host.owner()};
}

}  // namespace jostle::server
