// SPDX-License-Identifier: MIT
//
// ClientSession: what of a conversation outlives its connection, and how another one goes on with
// it.
#include <chrono>
#include <iterator>
#include <utility>

#include "server/session/client_session.h"
#include "server/util/address.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

// A link looks twenty times a second whether it is to give way.
constexpr auto give_way_max = std::chrono::seconds(2);
// A world that goes on elsewhere is there again within this, or its clients ask again.
constexpr auto world_replacement_max = std::chrono::seconds(10);

// A token that outlives the process is good for a day: a place is never kept so long.
constexpr auto token_life = std::chrono::hours(24);

// A world that an error ended may run again, as another host.
std::shared_ptr<WorldHost> host_of(PlayContext& context, const DisconnectedClient& lost) {
    const WorldHost& host = lost.broadcast->host();
    return context.worlds.find(host.id());
}

void release(PlayContext& context, const DisconnectedClient& lost) {
    log_info("client {} did not come back to world {}", lost.client, lost.broadcast->host().id());
    context.sessions.leave(lost.client);
    if (const auto host = host_of(context, lost))
        host->mailbox().leave(lost.client, context.config.client.retain_bodies_after_leave);
}

}  // namespace

void expect_resume(PlayContext& context, const std::shared_ptr<WorldHost>& world, ClientId client,
                   std::uint32_t last_sequence, Clock::time_point until) {
    context.sessions.restore_client(client, world->id(), {});
    world->mailbox().disconnect(client);
    context.resume_registry.expect({.client = client,
                                    .broadcast = context.broadcast_caches.cache_for(
                                        world, context.config.stream.interest_cell_m),
                                    .network = {},
                                    .subject = {},
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
        release(context, lost);
}

// A place that is kept for somebody who is not there is given to one who is.
Result<ClientId> ClientSession::acquire_client_id(const WorldHost& world) {
    const std::string network = network_of(peer_.address);
    Result<ClientId> client = context_.sessions.enter(world.id(), network);
    if (client.ok()) return client;
    std::optional<DisconnectedClient> lost = context_.resume_registry.take_oldest(network);
    if (!lost && context_.sessions.clients() >= context_.config.world.clients_max)
        lost = context_.resume_registry.take_oldest({});
    if (!lost) return client;
    release(context_, *lost);
    return context_.sessions.enter(world.id(), network);
}

std::shared_ptr<ResumeSession> ClientSession::open_resume_session(const WorldHost& world) {
    const ResumeToken who{.client = client_,
                          .world = world.id(),
                          .subject = metrics_.subject(),
                          .by_ticket = by_ticket_,
                          .spectator = spectator_,
                          .expires = std::chrono::floor<std::chrono::seconds>(
                              std::chrono::system_clock::now() + token_life)};
    return context_.resume_registry.open(client_, world.is_persisted() ? &who : nullptr);
}

void ClientSession::suspend(Clock::time_point now) {
    collect_results();
    broadcast_->host().mailbox().disconnect(client_);
    DisconnectedClient lost{.client = client_,
                            .broadcast = broadcast_,
                            .network = network_of(peer_.address),
                            .subject = metrics_.subject(),
                            .by_ticket = by_ticket_,
                            .spectator = spectator_,
                            .result_queue = result_queue_,
                            .results = std::move(results_),
                            .last_sequence = last_sequence_,
                            .persisted_sequence = persisted_sequence_,
                            .stream_resumable = can_resume_stream(),
                            .baselines = std::move(baselines_),
                            .sent = std::move(sent_log_),
                            .sent_geometry = std::move(sent_geometry_),
                            .channel_kinds = channel_kinds_};
    context_.resume_registry.suspend(
        *resume_session_, std::move(lost),
        now + from_seconds(context_.config.client.resume_timeout_seconds));
}

// By a ticket one comes in once; the token stands for it, and for no more than it allowed.
Status ClientSession::may_resume(const Hello& hello, const DisconnectedClient& lost) {
    if (lost.by_ticket) {
        if (lost.spectator && !hello.spectator)
            return Error{ErrorCode::permission_denied,
                         "you came in as a spectator; a player needs a ticket of his own"};
        metrics_.set_subject(lost.subject);
        return {};
    }
    const Result<std::shared_ptr<WorldHost>> world = authorize(hello);
    if (!world.ok()) return world.error();
    if (metrics_.subject() != lost.subject)
        return Error{ErrorCode::permission_denied, "that place is somebody else's"};
    if (world->get() != &lost.broadcast->host())
        return Error{ErrorCode::not_found, "that place is in another world"};
    return {};
}

// False: it comes in as one that is new.
bool ClientSession::resume(const Hello& hello, Clock::time_point now) {
    ResumeRegistry::Claim claim = context_.resume_registry.claim(hello.resume->token);
    if (claim.status == ResumeRegistry::ClaimStatus::unknown) return false;
    if (claim.status == ResumeRegistry::ClaimStatus::pending) {
        if (now - begun_ > give_way_max) return false;
        waiting_hello_ = std::make_unique<Hello>(hello);
        return true;
    }
    DisconnectedClient& lost = *claim.client;
    if (const auto host = host_of(context_, lost); host && host.get() != &lost.broadcast->host())
        lost.move_to(
            context_.broadcast_caches.cache_for(host, context_.config.stream.interest_cell_m));
    const bool world_is_there = !lost.broadcast->host().lifecycle().stopped();
    const auto timeout =
        lost.broadcast->host().lifecycle().was_replaced() ? world_replacement_max : give_way_max;
    if (!world_is_there && lost.broadcast->host().is_persisted() && now - begun_ <= timeout) {
        context_.resume_registry.suspend(*claim.resume_session, std::move(lost), claim.until);
        waiting_hello_ = std::make_unique<Hello>(hello);
        return true;
    }
    const Status may = world_is_there ? may_resume(hello, lost) : Status();
    if (!world_is_there || (!may.ok() && may.error().code == ErrorCode::not_found)) {
        context_.resume_registry.close(*claim.resume_session);
        release(context_, lost);
        return false;
    }
    if (!may.ok()) {
        context_.resume_registry.suspend(*claim.resume_session, std::move(lost), claim.until);
        refuse(may.error(), now);
        return true;
    }
    resume_session_ = std::move(claim.resume_session);
    by_ticket_ = lost.by_ticket;
    const auto world = context_.worlds.find(lost.broadcast->host().id());
    enter(world, hello, now, &lost);
    return true;
}

// Whom it may know that is no more, if it goes on from that frame; nothing: it begins anew.
std::optional<std::vector<EntityId>> ClientSession::resume_stream(DisconnectedClient& lost,
                                                                  std::uint32_t frame,
                                                                  const EntityList& now) {
    last_sequence_ = lost.last_sequence;
    persisted_sequence_ = lost.persisted_sequence;
    SentLog::Known known = lost.sent.known_at(frame, now);
    results_ = std::move(known.results);
    results_.insert(results_.end(), std::make_move_iterator(lost.results.begin()),
                    std::make_move_iterator(lost.results.end()));
    if (interest_ || !lost.stream_resumable || !known.list ||
        channel_kinds_ != lost.channel_kinds || !lost.baselines.roll_back_to(frame))
        return std::nullopt;
    baselines_ = std::move(lost.baselines);
    sent_log_ = std::move(lost.sent);
    sent_log_.roll_back_to(frame);
    entity_list_ = std::move(known.list);
    sent_geometry_ = std::move(lost.sent_geometry);
    for (const std::uint64_t id : known.geometry) sent_geometry_.erase(id);
    if (wants_events_) event_cursor_ = known.events;
    return std::move(known.removed);
}

}  // namespace jostle::server
