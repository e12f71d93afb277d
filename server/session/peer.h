// SPDX-License-Identifier: MIT
//
// Who is at the other end, as the transport knows; what the gate is asked about a world.
#pragma once

#include <functional>
#include <string>

#include "server/auth/authorizer.h"
#include "server/world/world_host.h"

namespace jostle::server {

struct Peer {
    std::string name;                   // for the log: "grpc:192.0.2.7:4711"
    std::string address;                // "192.0.2.7"
    std::string call;                   // the row of the access table by which it came
    Result<Identity> who = Identity{};  // an error: what it showed is not good
    // Any thread: a datagram came that the link should take soon, by take_datagrams(). Empty: the
    // transport takes none.
    std::function<void()> wake = {};
};

// Valid as long as the host.
inline WorldTarget world_target(const WorldHost& host) {
    return {host.id(), host.name(), host.properties().label.owner};
}

}  // namespace jostle::server
