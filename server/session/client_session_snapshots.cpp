// SPDX-License-Identifier: MIT
//
// The part of a ClientSession that says things: rosters, snapshots, and what travels in them.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "server/messages/event_message.h"
#include "server/messages/server_message.h"
#include "server/session/client_session.h"

namespace jostle::server {

namespace {

// Clients take messages of up to 4 MiB by default. A tick with more events than this is missed.
constexpr std::size_t events_bytes_max = 1 << 20;
constexpr double controlled_entity_updates_per_second = 16;
constexpr std::int64_t margin_us_max = 1'000'000'000;  // a tick that a client names may be any

std::int32_t within_margins(std::int64_t margin_us) {
    return static_cast<std::int32_t>(std::clamp(margin_us, -margin_us_max, margin_us_max));
}

}  // namespace

void ClientSession::send(std::string message) {
    outgoing_.push_back({std::move(message), nullptr});
    replies_pending_++;
}

void ClientSession::drop_outgoing() {
    outgoing_.clear();
    replies_pending_ = 0;
}

std::optional<OutMessage> ClientSession::take_message(Clock::time_point now) {
    handle_delayed_bytes(now);
    std::optional<OutMessage> message = next_message(now);
    if (network_simulator_) {
        for (; message; message = next_message(now))
            network_simulator_->push_outgoing(*std::move(message), now);
        message = network_simulator_->take_outgoing(now, end_.has_value());
    }
    if (message) metrics_.sent(*message, now);
    return message;
}

std::optional<OutMessage> ClientSession::next_message(Clock::time_point now) {
    writing_since_.reset();
    check_timeouts(now);
    if (outgoing_.empty() && broadcast_ && !end_) {
        if (const FramePtr frame = broadcast_->host().frame(); frame->tick != last_frame_tick_) {
            on_frame(*frame, now);
        }
        write_blocked_ = false;
        if (send_by_datagram(*broadcast_->host().frame(), now)) return take_reply(now);
        return take_snapshot(now);
    }
    if (outgoing_.empty()) return std::nullopt;
    OutMessage message = std::move(outgoing_.front());
    outgoing_.pop_front();
    if (!message.shared) replies_pending_--;
    if (flow_) flow_->on_other_sent();
    return message;
}

void ClientSession::wait_for_write(Clock::time_point now) {
    write_blocked_ = true;
    if (!writing_since_) writing_since_ = now;
    handle_delayed_bytes(now);
    check_timeouts(now);
    if (!end_ &&
        now - *writing_since_ > from_seconds(context_.config.stream.client_timeout_seconds))
        refuse(Error{ErrorCode::resource_exhausted,
                     fmt::format("nothing was read for {:g} s",
                                 context_.config.stream.client_timeout_seconds)},
               now, true);
    if (broadcast_ && !end_) collect_results();
}

// Whether this frame is one to send. Frames that came and went while a write was pending were
// skipped because of it.
void ClientSession::on_frame(const Frame& frame, Clock::time_point now) {
    const auto every = static_cast<std::uint32_t>(flow_->divider());
    if (write_blocked_ && last_frame_tick_ != 0) {
        skipped_pending_ += (frame.tick - 1) / every - last_frame_tick_ / every;
    }
    last_frame_tick_ = frame.tick;
    collect_results();
    snapshot_due_ = snapshot_due_ || (has_changes(frame, now) && flow_->may_send(frame.tick, now));
    metrics_.on_frame(*flow_, skipped_pending_);
}

// Anything since the last snapshot; and now and then nothing, so that the client knows so much.
bool ClientSession::has_changes(const Frame& frame, Clock::time_point now) {
    // What went by a datagram is told again until the client says that it has it.
    const std::uint32_t told =
        send_by_datagram(frame, now) ? datagrams_->frames().newest() : baselines_.last();
    return frame.changed_at > told || more_to_send_ || !results_.empty() ||
           (wants_events_ && event_cursor_ < frame.events->count) ||
           now - last_snapshot_ >= from_seconds(1 / context_.config.stream.heartbeats_per_second);
}

void ClientSession::collect_results() {
    std::vector<InputResult> fresh = result_queue_->take();
    for (const InputResult& result : fresh) {
        unsent_sequence_ = std::max(unsent_sequence_, result.sequence);
        if (result.status.ok() || result.status.error().code != ErrorCode::unavailable)
            persisted_sequence_ = std::max(persisted_sequence_, result.sequence);
        unsent_margin_us_ = within_margins(result.margin_us.value_or(unsent_margin_us_));
    }
    results_.insert(results_.end(), std::make_move_iterator(fresh.begin()),
                    std::make_move_iterator(fresh.end()));
}

// What only this client is told with a snapshot; each number when it is another than last time.
ClientUpdate ClientSession::client_update() {
    std::uint32_t answered = sent_update_.input_sequence;
    std::int64_t margin_us = 0;
    for (const InputResult& result : results_) {
        answered = std::max(answered, result.sequence);
        margin_us = result.margin_us.value_or(margin_us);
    }
    const std::uint32_t skipped = flow_->skipped() + skipped_pending_;
    ClientUpdate own{.echo_client_time_us = std::exchange(client_time_us_, 0), .results = results_};
    own.input_margin_us = within_margins(margin_us);
    if (datagrams_ && confirmed() != sent_received_)
        own.input_received = sent_received_ = confirmed();
    if (answered != sent_update_.input_sequence)
        own.input_sequence = sent_update_.input_sequence = answered;
    if (skipped != sent_update_.snapshots_skipped)
        own.snapshots_skipped = sent_update_.snapshots_skipped = skipped;
    return own;
}

// A field, or nothing when it is too early for the next.
std::string ClientSession::take_stats(const FramePtr& frame, Clock::time_point now) {
    if (now - last_stats_ < from_seconds(1 / context_.config.stream.stats_per_second)) return {};
    last_stats_ = now;
    const auto clients =
        static_cast<std::uint32_t>(context_.sessions.clients_in(broadcast_->host().id()));
    return *broadcast_->world_stats(frame, clients);
}

// The fields of all ticks up to the frame's, so that the client has been told of the entities. How
// many ticks may wait is up to the frame, which holds the newest few.
std::string ClientSession::take_events(const Frame& frame) {
    std::string fields;
    if (!wants_events_) return fields;
    const auto& ticks = frame.events->ticks;
    const std::uint32_t gone = frame.events->count - static_cast<std::uint32_t>(ticks.size());
    if (event_cursor_ < gone) {
        events_missed_ += gone - event_cursor_;
        event_cursor_ = gone;
    }
    for (; event_cursor_ < frame.events->count; event_cursor_++) {
        const SharedBytes shared = broadcast_->events(ticks[event_cursor_ - gone]);
        if (shared->size() > events_bytes_max) {
            events_missed_++;
            continue;
        }
        if (fields.size() + shared->size() > events_bytes_max) break;  // with the next one
        fields += encode_events_header(std::exchange(events_missed_, 0), shared->size());
        fields += *shared;
    }
    return fields;
}

// A field with what the client drives, if it foresees that, or nothing when it is too early for the
// next.
std::string ClientSession::take_controlled_entity(const Frame& frame) {
    if (!wants_controlled_entity_ || !frame.controlled_entities) return {};
    const auto mine =
        std::ranges::find(*frame.controlled_entities, client_, &ControlledEntityState::client);
    if (mine == frame.controlled_entities->end() || mine->entity == 0) return {};
    const bool keyframe =
        !sent_controlled_entity_ || sent_controlled_entity_->entity != mine->entity;
    const double every =
        std::max(1.0, std::round(broadcast_->host().hz() / controlled_entity_updates_per_second));
    if (!keyframe && frame.tick < sent_controlled_entity_->tick + static_cast<std::uint32_t>(every))
        return {};
    if (!sent_controlled_entity_)
        sent_controlled_entity_ = std::make_unique<SentControlledEntity>();
    std::string field =
        encode_controlled_entity_field(*mine, frame.tick, sent_controlled_entity_->words, keyframe);
    *sent_controlled_entity_ = {mine->entity, frame.tick, mine->words};
    return field;
}

// Shapes before the bodies that have them, each once in a stream.
void ClientSession::send_entities(const std::shared_ptr<const EntityList>& entities) {
    const auto messages = broadcast_->entity_list_change(entity_list_, entities);
    push(*messages);
    entity_list_ = entities;
    if (can_resume_stream()) sent_log_.on_list(entities, baselines_.last());
}

void ClientSession::push(const EntityUpdateMessages& messages) {
    for (const auto& geometry : messages.geometry) {
        if (!sent_geometry_.insert(geometry->id).second) continue;
        if (can_resume_stream()) sent_log_.on_geometry(geometry->id, baselines_.last());
        for (const SharedBytes& part : geometry->messages) outgoing_.push_back({{}, part});
    }
    for (const SharedBytes& roster : messages.entity_updates) outgoing_.push_back({{}, roster});
}

// A change of the entity list comes before the first snapshot that needs it, so when there is one
// it goes first, and the snapshot is made, of the then newest frame, when it has been taken.
std::optional<OutMessage> ClientSession::take_snapshot(Clock::time_point now) {
    if (!snapshot_due_) return std::nullopt;
    const FramePtr frame = broadcast_->host().frame();
    if (frame->tick <= newest_sent()) return std::nullopt;
    if (interest_) return take_cell_snapshot(frame, now);
    if (frame->entity_list != entity_list_) {
        send_entities(frame->entity_list);
        if (!outgoing_.empty()) return next_message(now);
    }
    return snapshot_of(frame, now, {}, {});
}

// By the stream or by datagrams.
std::uint32_t ClientSession::newest_sent() const {
    return datagrams_ ? std::max(baselines_.last(), datagrams_->frames().last_sent())
                      : baselines_.last();
}

OutMessage ClientSession::snapshot_of(const FramePtr& frame, Clock::time_point now,
                                      std::string more, std::vector<SharedBytes> cells) {
    if (datagrams_)
        if (auto baselines = datagrams_->take_stream_baselines())
            baselines_ = *std::move(baselines);
    std::size_t cells_bytes = 0;
    for (const SharedBytes& cell : cells) cells_bytes += cell->size();
    SharedBytes shared = broadcast_->snapshots().encoding(
        frame, baselines_.baselines_for(frame->tick), channel_kinds_,
        interest_ ? std::nullopt : std::optional(codec_));
    more += take_stats(frame, now) + take_events(*frame) + take_controlled_entity(*frame);
    OutMessage message{encode_snapshot_header(client_update(), more, shared->size() + cells_bytes),
                       std::move(shared), std::move(cells)};
    metrics_.answered(results_);
    if (resume_session_) sent_log_.on_snapshot(frame->tick, results_, event_cursor_);
    results_.clear();
    snapshot_due_ = false;
    last_snapshot_ = now;
    last_frame_tick_ = std::max(last_frame_tick_, frame->tick);
    baselines_.on_sent(frame->tick);
    if (datagrams_) datagrams_->on_sent_by_stream(frame->tick);
    flow_->on_sent(frame->tick, now);
    metrics_.sent_snapshot(message.size());
    return message;
}

}  // namespace jostle::server
