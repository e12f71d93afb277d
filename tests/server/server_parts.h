// SPDX-License-Identifier: MIT
//
// The parts of a server below its ports, with default settings. Fixtures derive from it.
#pragma once

#include <memory>
#include <utility>

#include "server/session/play_context.h"

namespace jostle::server {

struct ServerParts {
    ServerParts(int sessions_max, int worlds_max, WorldHostSettings settings = {})
        : sessions(sessions_max), worlds(std::move(settings), worlds_max) {}

    Config config;
    SessionDirectory sessions;
    WorldDirectory worlds;
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
};

// `server`: a GrpcServer.
template <class Server>
void stop_server(ServerParts& parts, Server& server) {
    parts.worlds.stop_all();  // before the objects that they notify
    parts.context.closing = true;
    server.drain({});
    server.wake();
    server.stop();
}

}  // namespace jostle::server
