// SPDX-License-Identifier: MIT
//
// What all conversations of a server share: its settings, its worlds, who is connected, who may do
// what, and what each world's clients are sent alike. Outlives them. Any thread.
#pragma once

#include <atomic>
#include <span>

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
    Metrics* metrics = nullptr;           // null: nobody counts
    RpcMetrics* rpc_metrics = nullptr;    // likewise
    DatagramServer* datagrams = nullptr;  // null: all goes by streams
    BroadcastCaches broadcast_caches{};
    ConnectedClients connected_clients{};
    ResumeRegistry resume_registry{};
    std::atomic<bool> drain_requested{false};  // by an operator; the app begins it as on a signal
    std::atomic<bool> draining{false};         // no new clients; those who play are told
    std::atomic<bool> closing{false};          // the drain is over: every conversation ends
};

// One that played when the process of before ended may come back until then; until it does it is
// as one whose connection broke.
void expect_resume(PlayContext& context, const std::shared_ptr<WorldHost>& world, ClientId client,
                   std::uint32_t last_sequence, Clock::time_point until);

// Those who played when a world was kept that goes on as another host: who is there still lets go
// of what it held, and who is not has left.
void reconcile_clients(PlayContext& context, WorldHost& world, std::span<const ClientId> clients);

// Clients whose connection broke too long ago have left. Now and then; any thread.
void remove_expired_clients(PlayContext& context, Clock::time_point now);

}  // namespace jostle::server
