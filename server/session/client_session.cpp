// SPDX-License-Identifier: MIT
#include "server/session/client_session.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "server/messages/server_message.h"
#include "server/util/address.h"
#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

using namespace std::chrono_literals;

namespace {

// Answers that were not taken: beyond this the client does not read what it asks for.
constexpr std::size_t replies_max = 256;
constexpr std::size_t results_max = 4096;
// A client that asks for absolute snapshots again and again costs its own bandwidth; more than this
// helps nobody.
constexpr auto keyframe_period = 250ms;
// A client that has been told and still sends this many times its rate is cut off.
constexpr int flood_factor = 5;
constexpr auto rate_notice_period = 1s;

// Every n-th tick, so that no more than `wanted` snapshots a second are sent.
int divider_of(double tick_hz, std::uint32_t wanted) {
    if (wanted == 0 || wanted >= tick_hz) return 1;
    return static_cast<int>(std::ceil(tick_hz / wanted));
}

// The best that both know.
wire::Codec codec_for(const Hello& hello, const StreamSettings& stream) {
    const auto ours = static_cast<std::uint32_t>(stream.codec);
    return static_cast<wire::Codec>(std::clamp(hello.codec, 1u, ours));
}

// A bit for each kind of the world that the client names, "*" being all of modules.
std::uint64_t kinds_named(const std::vector<physics::ChannelKind>& kinds,
                          const std::vector<std::string>& names) {
    std::uint64_t named = 0;
    for (std::size_t k = 0; k < kinds.size(); k++)
        for (const std::string& name : names)
            if (name == kinds[k].name || (name == "*" && kinds[k].name != motion_kind))
                named |= std::uint64_t{1} << k;
    return named;
}

std::uint64_t motion_bit(const std::vector<physics::ChannelKind>& kinds) {
    return kinds_named(kinds, {motion_kind});
}

}  // namespace

ClientSession::ClientSession(PlayContext& context, Peer peer, Clock::time_point now)
    : context_(context),
      peer_(std::move(peer)),
      begun_(now),
      last_received_(now),
      timeouts_checked_(now) {}

ClientSession::~ClientSession() {
    leave_world();
}

// --- what the client sends ---

void ClientSession::receive(std::string_view bytes, Clock::time_point now) {
    if (network_simulator_)
        network_simulator_->push_incoming(bytes, now);
    else
        handle_bytes(bytes, now);
}

void ClientSession::handle_delayed_bytes(Clock::time_point now, bool at_once) {
    if (!network_simulator_) return;
    while (const auto bytes = network_simulator_->take_incoming(now, at_once))
        handle_bytes(*bytes, now);
}

void ClientSession::handle_bytes(std::string_view bytes, Clock::time_point now) {
    if (end_) return;
    last_received_ = now;
    const auto bytes_max = static_cast<std::size_t>(context_.config.client.message_bytes_max);
    if (bytes.size() > bytes_max) {
        return refuse(Error{ErrorCode::resource_exhausted,
                            fmt::format("a message of {} bytes; at most {} are allowed",
                                        bytes.size(), bytes_max)},
                      now);
    }
    if (admission_ && !admission_->admit_message(bytes.size(), now)) return drop_message(now);
    const Result<ClientMessage> message = decode_client_message(bytes);
    if (!message.ok()) return refuse(message.error(), now);
    if (!broadcast_ && !std::holds_alternative<Hello>(*message)) {
        return refuse(Error{ErrorCode::failed_precondition, "the first message must be a Hello"},
                      now);
    }
    std::visit([&](const auto& decoded) { on_message(decoded, now); }, *message);
}

// Not even parsed: a flood should cost its sender more than us.
void ClientSession::drop_message(Clock::time_point now) {
    dropped_++;
    if (now - dropping_since_ < rate_notice_period) {
        if (dropped_ > flood_factor * limits_.messages_per_second) {
            refuse(Error{ErrorCode::resource_exhausted, "far too many messages"}, now);
        }
        return;
    }
    dropping_since_ = now;
    dropped_ = 1;
    send(encode_notice(
        NoticeKind::rate_limit,
        fmt::format("more than {:g} messages or {:g} bytes a second: what is beyond that "
                    "is dropped; put several inputs into one batch",
                    limits_.messages_per_second, limits_.bytes_per_second)));
}

void ClientSession::on_message(const Hello& hello, Clock::time_point now) {
    if (broadcast_) return refuse(Error{ErrorCode::failed_precondition, "a second Hello"}, now);
    if (context_.draining) {
        return refuse(Error{ErrorCode::unavailable, "the server is going down; try another"}, now);
    }
    if (hello.protocol != protocol_version) {
        return refuse(Error{ErrorCode::failed_precondition,
                            fmt::format("hello.protocol is {}; this server speaks {}",
                                        hello.protocol, protocol_version)},
                      now);
    }
    if (hello.resume && resume(hello, now)) return;
    const Result<std::shared_ptr<WorldHost>> world =
        hello.ticket.empty() ? authorize(hello) : authorize_by_ticket(hello);
    if (!world.ok()) return refuse(world.error(), now);
    by_ticket_ = !hello.ticket.empty();
    enter(*world, hello, now);
}

Result<std::shared_ptr<WorldHost>> ClientSession::find_world(const std::string& wanted) const {
    std::shared_ptr<WorldHost> world = context_.worlds.find(wanted);
    if (world) return world;
    return Error{ErrorCode::not_found, wanted.empty() ? "the server has no world"
                                                      : "there is no world " + quoted(wanted)};
}

// By the token of the stream or of the hello, or as one who shows none.
Result<std::shared_ptr<WorldHost>> ClientSession::authorize(const Hello& hello) {
    const Result<Identity> who =
        hello.token.empty()
            ? peer_.who
            : context_.authorizer.identify({.bearer = hello.token, .address = peer_.address});
    if (!who.ok()) return who.error();
    Result<std::shared_ptr<WorldHost>> world = find_world(hello.world);
    if (!world.ok()) return world;
    const AccessRequest ask{peer_.call, world_target(**world), peer_.address};
    if (Status s = context_.authorizer.admit(*who, ask); !s.ok()) return s.error();
    if (Status s = check_play_access(hello, *who, **world); !s.ok()) return s.error();
    metrics_.set_subject(who->subject);
    return world;
}

Result<std::shared_ptr<WorldHost>> ClientSession::authorize_by_ticket(const Hello& hello) {
    std::string named;
    if (!hello.world.empty()) {
        const Result<std::shared_ptr<WorldHost>> world = find_world(hello.world);
        if (!world.ok()) return world.error();
        named = (*world)->id();
    }
    const Result<Authorizer::Entry> entry =
        context_.authorizer.redeem_ticket(hello.ticket, named, peer_.address);
    if (!entry.ok()) return entry.error();
    Result<std::shared_ptr<WorldHost>> world = find_world(entry->world_id);
    if (!world.ok()) return world;
    if (Status s = check_play_access(hello, entry->who, **world); !s.ok()) return s.error();
    metrics_.set_subject(entry->who.subject);
    return world;
}

Status ClientSession::check_play_access(const Hello& hello, const Identity& who,
                                        const WorldHost& world) const {
    if (hello.spectator) return {};
    return context_.authorizer.admit(who, {play_inputs, world_target(world), peer_.address});
}

void ClientSession::enter(const std::shared_ptr<WorldHost>& world, const Hello& hello,
                          Clock::time_point now, DisconnectedClient* lost) {
    const Result<ClientId> client = lost ? lost->client : acquire_client_id(*world);
    if (!client.ok()) return refuse(client.error(), now);
    client_ = *client;
    spectator_ = hello.spectator;
    broadcast_ =
        lost ? lost->broadcast
             : context_.broadcast_caches.cache_for(world, context_.config.stream.interest_cell_m);
    result_queue_ = lost ? lost->result_queue : std::make_shared<ResultQueue>();
    if (!lost && hello.resumable && context_.config.client.resume_timeout_seconds > 0)
        resume_session_ = open_resume_session(*world);
    const int divider = divider_of(world->hz(), hello.snapshot_hz);
    // A client may acknowledge each snapshot by itself, whatever the world's rate.
    limits_ = context_.config.client;
    limits_.messages_per_second += world->hz() / divider;
    admission_.emplace(limits_, hello.spectator, now);
    flow_.emplace(context_.config.stream, world->hz(), divider);
    if (hello.interest || hello.max_kbps != 0) {
        interest_ = std::make_unique<InterestView>(hello.max_kbps * 125.0);
        if (hello.interest) interest_->set_interest(*hello.interest);
    }
    if (hello.events) {
        wants_events_ = true;
        world->listeners().events++;
    }
    channel_kinds_ = kinds_named(world->properties().channel_kinds, hello.channels);
    const std::uint64_t motion = motion_bit(world->properties().channel_kinds);
    wants_controlled_entity_ = (channel_kinds_ & motion) != 0;
    if (wants_controlled_entity_) world->listeners().controlled_entities++;
    // That is of all bodies, and such a client is told of some.
    if (interest_) channel_kinds_ &= ~motion;
    wants_motion_ = (channel_kinds_ & motion) != 0;
    if (wants_motion_) world->listeners().motion++;
    codec_ = codec_for(hello, context_.config.stream);
    const FramePtr frame = world->frame();
    event_cursor_ = frame->events->count;
    const auto gone =
        lost ? resume_stream(*lost, hello.resume->frame, *frame->entity_list) : std::nullopt;
    Welcome welcome{
        .client = client_,
        .world_id = world->id(),
        .world_name = world->name(),
        .tick = frame->tick,
        .tick_hz = world->hz(),
        .snapshot_hz = static_cast<std::uint32_t>(std::lround(world->hz() / divider)),
        .ack_interval_ms = static_cast<std::uint32_t>(context_.config.stream.ack_interval_ms),
        .quant = broadcast_->snapshots().spec(),
        .server_time_us = to_us(now),
        .epoch_us = to_us(world->properties().epoch),
        .gravity = world->properties().gravity,
        .substeps = world->properties().substeps,
        .channels = world->properties().channel_kinds,
        .codec = codec_,
        .cells = interest_ != nullptr,
        .resume_token = resume_session_ ? resume_session_->token : std::string(),
        .resumed = lost != nullptr,
        .state_preserved = gone.has_value(),
        .last_sequence = confirmed(),
        .resume_timeout_seconds =
            resume_session_ ? context_.config.client.resume_timeout_seconds : 0};
    offer_datagrams(hello, welcome);
    send(encode_welcome(welcome));
    if (gone && !gone->empty())
        outgoing_.push_back({{}, std::make_shared<const std::string>(encode_removed(*gone))});
    snapshot_due_ = true;  // the first one goes out at once
    network_simulator_ =
        make_network_simulator(context_.config.development, world->name(), client_);
    metrics_.entered({.id = client_,
                      .name = hello.name,
                      .world_id = world->id(),
                      .world_name = world->name(),
                      .address = peer_.name,
                      .spectator = hello.spectator,
                      .since = now},
                     *world);
    log_info("client {} {} of {} {} world {}{}", client_, quoted(hello.name), peer_.name,
             lost ? "came back to" : "joined", world->id(),
             hello.spectator ? " as a spectator" : "");
}

void ClientSession::on_message(const InputBatch& batch, Clock::time_point now) {
    const auto inputs_max = static_cast<std::size_t>(context_.config.client.inputs_per_batch_max);
    if (batch.inputs.size() > inputs_max) {
        return refuse(Error{ErrorCode::invalid_argument,
                            fmt::format("a batch of {} inputs; at most {} are allowed",
                                        batch.inputs.size(), inputs_max)},
                      now);
    }
    if (batch.ack) on_message(*batch.ack, now);
    client_time_us_ = batch.client_time_us;
    std::uint32_t sequence = batch.first_sequence;
    for (std::size_t k = 0; k < batch.inputs.size(); k++)
        push_input(sequence++, batch.inputs[k], batch.ticks[k], now);
}

// What came before is neither applied nor answered again.
void ClientSession::push_input(std::uint32_t sequence, const Result<Action>& input,
                               std::uint32_t tick, Clock::time_point now) {
    if (sequence <= last_sequence_) return;
    last_sequence_ = sequence;
    if (Status status = try_push_input(sequence, input, tick, now); !status.ok())
        results_.push_back(
            {.sequence = sequence, .status = std::move(status), .tick = last_frame_tick_});
}

Status ClientSession::try_push_input(std::uint32_t sequence, const Result<Action>& input,
                                     std::uint32_t tick, Clock::time_point now) {
    if (!input.ok()) return Error{ErrorCode::invalid_argument, input.error().message};
    if (Status status = admission_->admit_input(*input, now); !status.ok()) return status;
    if (!broadcast_->host().mailbox().push({.client = client_,
                                            .sequence = sequence,
                                            .action = *input,
                                            .reply = result_queue_,
                                            .received = now,
                                            .tick = tick}))
        return Error{ErrorCode::resource_exhausted, "the world has too many inputs waiting"};
    return {};
}

void ClientSession::on_message(const Ack& ack, Clock::time_point now) {
    flow_->on_ack(ack.frame, std::chrono::milliseconds(ack.ack_delay_ms), now);
    sent_log_.on_ack(ack.frame);
    if (datagrams_) datagrams_->on_ack(ack.frame, ack.ack_bits, now);
    if (!ack.need_keyframe || now - last_keyframe_ < keyframe_period) return;
    last_keyframe_ = now;
    baselines_.reset();
    if (datagrams_) datagrams_->frames().reset();
    if (interest_) interest_->reset();
}

void ClientSession::on_message(const Ping& ping, Clock::time_point now) {
    send(encode_pong(ping.client_time_us, to_us(now)));
}

void ClientSession::on_message(const Interest& interest, Clock::time_point now) {
    if (!interest_)
        return refuse(Error{ErrorCode::failed_precondition,
                            "an interest in a stream without one; name the first in the hello"},
                      now);
    interest_->set_interest(interest);
}

void ClientSession::on_message(const Leave&, Clock::time_point now) {
    finish({}, now);
}

void ClientSession::on_peer_closed(Clock::time_point now) {
    handle_delayed_bytes(now, true);
    drop_outgoing();
    if (!end_) finish({}, now, true);
}

void ClientSession::on_fault(Clock::time_point now) {
    drop_outgoing();
    results_.clear();
    finish(Error{ErrorCode::internal, "a fault of the server ended the conversation"}, now);
}

// --- how it ends ---

void ClientSession::refuse(Error error, Clock::time_point now, bool lost) {
    if (end_) return;
    log_warn("{} was refused: {}",
             client_ ? fmt::format("client {} of {}", client_, peer_.name) : peer_.name,
             error.message);
    metrics_.refused(error.code);
    send(encode_notice(NoticeKind::refused, error.message));
    finish(std::move(error), now, lost);
}

void ClientSession::finish(Status status, Clock::time_point now, bool lost) {
    if (end_) return;
    end_ = std::move(status);
    end_time_ = now;
    // Who is there when the server goes down has not left a world that is kept.
    const bool world_goes_on = broadcast_ && broadcast_->host().is_persisted();
    lost = resume_session_ && (lost || context_.closing) && (world_goes_on || !context_.draining);
    if (client_ != 0)
        log_info("client {} {} world {}", client_, lost ? "lost" : "left", broadcast_->host().id());
    leave_world(lost ? std::optional(now) : std::nullopt);
}

void ClientSession::leave_world(std::optional<Clock::time_point> lost) {
    if (client_ == 0) return;
    metrics_.left();
    if (wants_events_) broadcast_->host().listeners().events--;
    if (wants_motion_) broadcast_->host().listeners().motion--;
    if (wants_controlled_entity_) broadcast_->host().listeners().controlled_entities--;
    if (lost) {
        suspend(*lost);
    } else {
        if (resume_session_) context_.resume_registry.close(*resume_session_);
        // The session ends first: a host that replaces this world reads the list of sessions.
        context_.sessions.leave(client_);
        const std::shared_ptr<WorldHost> current = context_.worlds.find(broadcast_->host().id());
        (current ? *current : broadcast_->host())
            .mailbox()
            .leave(client_, context_.config.client.retain_bodies_after_leave);
    }
    client_ = 0;
    datagrams_.reset();
}

void ClientSession::forgive_process_stall(Clock::time_point now) {
    const Clock::duration pause = now - std::exchange(timeouts_checked_, now);
    if (pause <= process_stall_min) return;
    begun_ += pause;
    last_received_ = std::min(last_received_ + pause, now);
    if (writing_since_) writing_since_ = std::min(*writing_since_ + pause, now);
}

// What time alone decides, and what the server as a whole decided.
void ClientSession::check_timeouts(Clock::time_point now) {
    if (end_) return;
    forgive_process_stall(now);
    const StreamSettings& limits = context_.config.stream;
    if (context_.closing) return finish(Error{ErrorCode::unavailable, "the server went down"}, now);
    if (context_.draining && !draining_sent_) {
        draining_sent_ = true;
        send(encode_notice(
            NoticeKind::draining,
            fmt::format("the server goes down in {:g} s", context_.config.drain_timeout_seconds)));
    }
    if (waiting_hello_) return on_message(*std::exchange(waiting_hello_, nullptr), now);
    if (!broadcast_) {
        if (now - begun_ > from_seconds(limits.hello_timeout_seconds)) {
            refuse(Error{ErrorCode::deadline_exceeded,
                         fmt::format("no Hello within {:g} s", limits.hello_timeout_seconds)},
                   now);
        }
        return;
    }
    if (const auto why = metrics_.kicked())
        return refuse(Error{ErrorCode::permission_denied, "you were removed: " + *why}, now);
    if (resume_session_ && resume_session_->is_superseded)
        return finish(Error{ErrorCode::aborted, "you came back by another connection"}, now, true);
    if (now - last_received_ > from_seconds(limits.client_timeout_seconds)) {
        return refuse(Error{ErrorCode::deadline_exceeded,
                            fmt::format("nothing heard for {:g} s; send an Ack or a Ping",
                                        limits.client_timeout_seconds)},
                      now, true);
    }
    if (broadcast_->host().lifecycle().failed()) {
        const bool kept = broadcast_->host().is_persisted();
        const char* why =
            kept ? "a fault of the server ended the world; it goes on from what was kept of it"
                 : "a fault of the server ended the world; it starts anew from its scene";
        send(encode_notice(NoticeKind::world_restarted, why));
        return finish(Error{ErrorCode::unavailable, why}, now, kept);
    }
    if (broadcast_->host().lifecycle().was_replaced()) {
        const char* why = "the world is taken back to an earlier tick";
        send(encode_notice(NoticeKind::world_restarted, why));
        return finish(Error{ErrorCode::unavailable, why}, now, true);
    }
    if (broadcast_->host().lifecycle().stopped()) {
        send(encode_notice(NoticeKind::world_closed, "the world was closed"));
        return finish(Error{ErrorCode::aborted, "the world was closed"}, now);
    }
    if (replies_pending_ > replies_max || results_.size() > results_max) {
        drop_outgoing();
        refuse(Error{ErrorCode::resource_exhausted, "the client asks but does not read"}, now);
    }
}

}  // namespace jostle::server
