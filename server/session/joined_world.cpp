// SPDX-License-Identifier: MIT
#include "server/session/joined_world.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "jostle/base/check.h"
#include "server/limits/account.h"
#include "server/session/room_admission.h"
#include "server/session/world_admission.h"
#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

// Every n-th tick, for at most `wanted` snapshots per second; 0: every tick.
int divider_of(double tick_hz, std::uint32_t wanted) {
    if (wanted == 0 || wanted >= tick_hz) return 1;
    return static_cast<int>(std::ceil(tick_hz / wanted));
}

// The setting of the client takes precedence over that of the world, and this one over that of the
// server.
StreamPrecision precision_of(const Hello& hello, const scenes::SceneDescription& scene,
                             const StreamSettings& settings) {
    if (hello.precision) return granted(*hello.precision);
    const scenes::StreamPrecision& world = scene.precision;
    if (world.position != 0) return granted({{world.position, world.rotation}, world.far_factor});
    return granted({{settings.position_precision_m, settings.rotation_precision_rad},
                    settings.far_precision_factor});
}

// A client may acknowledge each snapshot with its own message, at any rate of the world.
ClientLimits limits_with_acks(ClientLimits limits, double snapshot_hz) {
    limits.messages_per_second += snapshot_hz;
    return limits;
}

Status check_hello(const PlayContext& context, const Hello& hello) {
    if (context.draining)
        return Error{ErrorCode::unavailable,
                     "the server is shutting down; connect to another server"};
    if (hello.protocol != protocol_version)
        return Error{ErrorCode::failed_precondition,
                     fmt::format("hello.protocol is {}; this server supports {}", hello.protocol,
                                 protocol_version)};
    return {};
}

// Releases the id of a client if memory runs out while it joins.
struct IdGuard {
    const JoinedWorld::Parts& parts;
    ClientId client;

    ~IdGuard() {
        if (client == 0) return;
        parts.resume.close();
        parts.context.sessions.leave(client);
    }
};

std::unique_ptr<JoinedWorld> join(const JoinedWorld::Parts& parts, ClientId client,
                                  const std::shared_ptr<WorldHost>& world, const Hello& hello,
                                  DisconnectedClient* lost, Clock::time_point now) {
    IdGuard guard{parts, client};
    if (!lost && hello.resumable && parts.context.config.client.resume_timeout_seconds > 0)
        parts.resume.open(client, *world);
    auto joined = std::make_unique<JoinedWorld>(parts, client, world, hello, lost, now);
    guard.client = 0;  // from here on `joined` releases it
    joined->enter(hello, lost, now);
    return joined;
}

Result<std::unique_ptr<JoinedWorld>> join_as_new(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::time_point now) {
    const Result<AdmittedClient> admitted =
        admit_to_world(parts.context, parts.peer, hello, parts.resume.redeemed_ticket());
    if (!admitted.ok()) return admitted.error();
    if (Status s = check_room_capacity(*admitted->world, parts.context.sessions, admitted->who,
                                       parts.peer.address);
        !s.ok())
        return s.error();
    const Result<ClientId> client =
        acquire_client_id(parts.context, *admitted->world, parts.peer.address,
                          admitted->who.anonymous ? std::string() : admitted->who.subject,
                          room_capacity(*admitted->world, admitted->who, parts.peer.address));
    if (!client.ok()) return client.error();
    parts.metrics.set_subject(admitted->who.subject);
    parts.resume.set_holder({admitted->who, admitted->ticket, hello.spectator});
    return join(parts, *client, admitted->world, hello, nullptr, now);
}

}  // namespace

JoinedWorld::JoinedWorld(const Parts& parts, ClientId client,
                         const std::shared_ptr<WorldHost>& world, const Hello& hello,
                         DisconnectedClient* lost, Clock::time_point now)
    : parts_(parts),
      client_(client),
      broadcast_(lost ? lost->broadcast
                      : parts.context.broadcast_caches.cache_for(
                            world, parts.context.config.stream.interest_cell_m)),
      divider_(divider_of(host().hz(), hello.snapshot_hz)),
      limits_(limits_with_acks(parts.context.config.client, host().hz() / divider_)),
      inputs_(host().mailbox(),
              {.client = client,
               .account = account_of(parts.metrics.subject(), parts.peer.address),
               .spectator = hello.spectator,
               .persisted = host().is_persisted()},
              limits_, lost ? lost->result_queue : std::make_shared<ResultQueue>(), now),
      snapshots_({.context = parts.context,
                  .metrics = parts.metrics,
                  .broadcast = *broadcast_,
                  .poses = broadcast_->poses(
                      precision_of(hello, *host().properties().scene, parts.context.config.stream)),
                  .inputs = inputs_,
                  .outbox = parts.outbox,
                  .overload = parts.peer.overload,
                  .sent_log = parts.resume.sent_log(),
                  .client = client},
                 hello, divider_),
      flood_guard_(limits_.messages_per_second) {
    ASSERT(!lost || lost->client == client);
}

void JoinedWorld::enter(const Hello& hello, DisconnectedClient* lost, Clock::time_point now) {
    ASSERT(!has_entered_);
    has_entered_ = true;
    if (host().properties().is_room)
        host().mailbox().enter(
            client_, room_entry(parts_.resume.who(), parts_.peer.address, hello.spectator));
    const FramePtr frame = snapshots_.on_enter();
    host().mailbox().join(client_, {.name = has_control_character(hello.name)
                                                ? printable(hello.name, player_name_bytes_max)
                                                : hello.name,
                                    .role = initial_role(hello.spectator),
                                    .color = hello.color});
    if (lost) snapshots_.resume_messages(lost->messages_at_entry, hello.resume->message);
    const auto removed =
        lost ? resume(*lost, hello.resume->frame, *frame->entity_list) : std::nullopt;
    Welcome message = welcome(*frame, now);
    message.resumed = lost != nullptr;
    message.state_preserved = removed.has_value();
    DatagramServer* const server = parts_.context.datagrams;
    if (hello.datagrams && server && parts_.peer.wake && !snapshots_.has_cells())
        datagrams_ = DatagramTransport::open(
            *server,
            {.host = host(), .inputs = inputs_, .snapshots = snapshots_, .client = client_},
            parts_.peer.wake, message);
    parts_.outbox.push_reply(encode_welcome(message));
    if (removed && !removed->empty())
        parts_.outbox.push_shared(std::make_shared<const std::string>(encode_removed(*removed)));
    parts_.metrics.entered({.id = client_,
                            .name = hello.name,
                            .world_id = host().id(),
                            .world_name = host().name(),
                            .address = parts_.peer.name,
                            .spectator = hello.spectator,
                            .since = now},
                           host());
    log_info("client {} {} of {} {} world {}{}", client_, quoted(hello.name), parts_.peer.name,
             lost ? "resumed in" : "joined", host().id(), hello.spectator ? " as a spectator" : "");
}

Welcome JoinedWorld::welcome(const Frame& frame, Clock::time_point now) const {
    const WorldProperties& world = host().properties();
    const Config& config = parts_.context.config;
    return {.client = client_,
            .world_id = host().id(),
            .world_name = host().name(),
            .tick = frame.tick,
            .tick_hz = host().hz(),
            .snapshot_hz = static_cast<std::uint32_t>(std::lround(host().hz() / divider_)),
            .ack_interval_ms = static_cast<std::uint32_t>(config.stream.ack_interval_ms),
            .quant = snapshots_.poses().snapshots().spec(),
            .precision = snapshots_.poses().precision(),
            .server_time_us = to_us(now),
            .epoch_us = to_us(world.epoch),
            .gravity = world.gravity,
            .substeps = world.substeps,
            .channels = world.channel_kinds,
            .codec = snapshots_.codec(),
            .cells = snapshots_.has_cells(),
            .resume_token = parts_.resume.token(),
            .last_sequence = inputs_.confirmed(),
            .resume_timeout_seconds =
                parts_.resume.is_open() ? config.client.resume_timeout_seconds : 0,
            .planar = world.scene->world.planar,
            .view = world.scene->view};
}

// Returns the removed entities that the client may still have, if its stream continues after
// `frame`; nothing: its stream starts again with a keyframe. `now`: the current entity list.
std::optional<std::vector<EntityId>> JoinedWorld::resume(DisconnectedClient& lost,
                                                         std::uint32_t frame,
                                                         const EntityList& now) {
    SentLog::Known known = lost.sent.known_at(frame, now);
    std::vector<InputResult> results = std::move(known.results);
    results.insert(results.end(), std::make_move_iterator(lost.results.begin()),
                   std::make_move_iterator(lost.results.end()));
    inputs_.resume(lost.last_sequence, lost.persisted_sequence, std::move(results));
    if (!snapshots_.resume(lost, known, frame)) return std::nullopt;
    return std::move(known.removed);
}

void JoinedWorld::leave(std::optional<Clock::time_point> suspended) {
    if (std::exchange(has_left_, true)) return;
    if (has_entered_) {
        parts_.metrics.left();
        snapshots_.on_leave();
    }
    if (suspended)
        parts_.resume.suspend(suspended_state(), *suspended);
    else
        leave_for_good();
    datagrams_.reset();
}

void JoinedWorld::leave_for_good() {
    parts_.resume.close();
    // The session ends before the command: a host that replaces this world reads the directory.
    parts_.context.sessions.leave(client_);
    const std::shared_ptr<WorldHost> current = parts_.context.worlds.find(host().id());
    (current ? *current : host())
        .mailbox()
        .leave(client_, parts_.context.config.client.retain_bodies_after_leave);
}

DisconnectedClient JoinedWorld::suspended_state() {
    inputs_.collect_results();
    host().mailbox().disconnect(client_);
    DisconnectedClient lost{.client = client_,
                            .broadcast = broadcast_,
                            .network = {},
                            .result_queue = inputs_.queue(),
                            .results = inputs_.take_results(),
                            .last_sequence = inputs_.last_sequence(),
                            .persisted_sequence = inputs_.persisted_sequence(),
                            .baselines = {},
                            .sent = {},
                            .sent_geometry = {}};
    snapshots_.suspend(lost);
    return lost;
}

Status JoinedWorld::receive(const InputBatch& batch, Clock::time_point now) {
    if (Status s = inputs_.receive(batch, snapshots_.last_frame(), now); !s.ok()) return s;
    if (batch.ack) snapshots_.on_ack(*batch.ack, now);
    return {};
}

FloodGuard::Verdict JoinedWorld::on_excess_message(Clock::time_point now) {
    const FloodGuard::Verdict verdict = flood_guard_.on_excess(now);
    if (verdict == FloodGuard::Verdict::notify)
        parts_.outbox.push_reply(encode_notice(
            NoticeKind::rate_limit,
            fmt::format("messages are dropped: the client sends more than {:g} messages or {:g} "
                        "bytes per second; put several inputs into one batch",
                        limits_.messages_per_second, limits_.bytes_per_second)));
    return verdict;
}

Result<std::unique_ptr<JoinedWorld>> enter_world(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::duration age,
                                                 Clock::time_point now) {
    if (Status s = check_hello(parts.context, hello); !s.ok()) return s.error();
    if (!hello.resume) return join_as_new(parts, hello, now);
    SessionResume::Attempt attempt = parts.resume.attempt(hello, age);
    switch (attempt.outcome) {
        case SessionResume::Outcome::new_client:
            return join_as_new(parts, hello, now);
        case SessionResume::Outcome::waiting:
            return std::unique_ptr<JoinedWorld>();
        case SessionResume::Outcome::rejected:
            return *std::move(attempt.error);
        case SessionResume::Outcome::resumed:
            break;
    }
    ASSERT(attempt.client.has_value());
    parts.metrics.set_subject(parts.resume.who().subject);
    if (!parts.resume.who().anonymous)
        parts.context.sessions.set_subject(attempt.client->client, parts.resume.who().subject);
    DisconnectedClient& lost = *attempt.client;
    return join(parts, lost.client, nullptr, hello, &lost, now);
}

}  // namespace jostle::server
