// SPDX-License-Identifier: MIT
#include "server/session/play_context.h"

#include <memory>
#include <optional>

#include "server/util/address.h"
#include "server/util/log.h"

namespace jostle::server {

void release_client(PlayContext& context, const DisconnectedClient& lost) {
    const std::string& world_id = lost.broadcast->host().id();
    log_info("client {} did not resume in world {}", lost.client, world_id);
    context.sessions.leave(lost.client);
    // Another host may have replaced the client's world.
    if (const auto host = context.worlds.find(world_id))
        host->mailbox().leave(lost.client, context.config.client.retain_bodies_after_leave);
}

Result<ClientId> acquire_client_id(PlayContext& context, const WorldHost& world,
                                   const std::string& address, const std::string& subject,
                                   std::uint32_t world_max) {
    const std::string network = network_of(address);
    if (context.sessions.is_at_limit(subject))
        if (const auto lost = context.resume_registry.take_oldest_of(subject))
            release_client(context, *lost);
    Result<ClientId> client = context.sessions.enter(world.id(), network, subject, world_max);
    if (client.ok()) return client;
    std::optional<DisconnectedClient> lost = context.resume_registry.take_oldest(network);
    if (!lost && context.sessions.clients() >= context.config.world.clients_max)
        lost = context.resume_registry.take_oldest({});
    if (!lost) return client;
    release_client(context, *lost);
    return context.sessions.enter(world.id(), network, subject, world_max);
}

void expect_resume(PlayContext& context, const std::shared_ptr<WorldHost>& world, ClientId client,
                   std::uint32_t last_sequence, Clock::time_point until) {
    context.sessions.restore_client(client, world->id(), {});
    world->mailbox().disconnect(client);
    context.resume_registry.expect({.client = client,
                                    .broadcast = context.broadcast_caches.cache_for(
                                        world, context.config.stream.interest_cell_m),
                                    .network = {},
                                    .result_queue = std::make_shared<ResultQueue>(),
                                    .results = {},
                                    .last_sequence = last_sequence,
                                    .persisted_sequence = last_sequence,
                                    .baselines = {},
                                    .sent = {},
                                    .sent_geometry = {}},
                                   until);
}

void reconcile_clients(PlayContext& context, WorldHost& world, std::span<const ClientId> clients) {
    for (const ClientId client : clients) {
        if (context.sessions.has(client))
            world.mailbox().disconnect(client);
        else
            world.mailbox().leave(client, context.config.client.retain_bodies_after_leave);
    }
}

void remove_expired_clients(PlayContext& context, Clock::time_point now) {
    for (const DisconnectedClient& lost : context.resume_registry.take_expired(now))
        release_client(context, lost);
}

}  // namespace jostle::server
