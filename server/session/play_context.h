// SPDX-License-Identifier: MIT
//
// State shared by all sessions of a server: settings, worlds, connected clients, authorization and
// the broadcast cache of each world. Outlives all sessions. Any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "jostle/base/result.h"
#include "server/auth/authorizer.h"
#include "server/config/config.h"
#include "server/limits/connected_clients.h"
#include "server/limits/session_directory.h"
#include "server/metrics/rpc_metrics.h"
#include "server/session/broadcast_cache.h"
#include "server/session/resume_registry.h"
#include "server/udp/datagram_server.h"
#include "server/world/world_directory.h"

namespace jostle::server {

struct PlayContext {
    const Config& config;
    WorldDirectory& worlds;
    SessionDirectory& sessions;
    Authorizer& authorizer;
    Metrics* metrics = nullptr;           // null: no counting
    RpcMetrics* rpc_metrics = nullptr;    // null: no counting
    DatagramServer* datagrams = nullptr;  // null: streams carry everything
    BroadcastCaches broadcast_caches{};
    ConnectedClients connected_clients{};
    ResumeRegistry resume_registry{};
    std::atomic<bool> drain_requested{false};  // by an operator; the app then starts the drain
    std::atomic<bool> draining{false};         // reject new clients and notify connected ones
    std::atomic<bool> closing{false};          // the drain is over: every session ends
};

// Assigns an id to a new client. If the server or the client's network is full, the disconnected
// client that was suspended first leaves to make room. Errors: there is no such client.
// A suspended session of a subject that has its maximum of sessions leaves as well. `subject`:
// empty for anonymous clients. `world_max`: of the clients of the world; 0: no limit.
Result<ClientId> acquire_client_id(PlayContext& context, const WorldHost& world,
                                   const std::string& address, const std::string& subject = {},
                                   std::uint32_t world_max = 0);

// A disconnected client that was taken from the registry leaves the server and its world.
void release_client(PlayContext& context, const DisconnectedClient& lost);

// A client of an earlier process may resume until `until`. Until then it counts as disconnected.
void expect_resume(PlayContext& context, const std::shared_ptr<WorldHost>& world, ClientId client,
                   std::uint32_t last_sequence, Clock::time_point until);

// `clients`: the clients of the persisted state from which another host continues a world. Those
// that are still on the server release their grabs and controlled entities; the others leave.
void reconcile_clients(PlayContext& context, WorldHost& world, std::span<const ClientId> clients);

// Disconnected clients whose resume timeout is over leave. Call it periodically; any thread.
void remove_expired_clients(PlayContext& context, Clock::time_point now);

}  // namespace jostle::server
