// SPDX-License-Identifier: MIT
#include "server/session/snapshot_stream.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/server_message.h"

namespace jostle::server {

using namespace std::chrono_literals;

namespace {

// Requests for keyframes within this period are ignored: further keyframes only cost the client
// its bandwidth.
constexpr auto keyframe_period = 250ms;
// A frame that is older than the newest one by more than this number of ticks is not sent.
constexpr std::uint32_t shared_frame_age_max = 2;

// The highest codec that both sides support.
snapshot::Codec codec_for(const Hello& hello, const StreamSettings& settings) {
    const auto highest = static_cast<std::uint32_t>(settings.codec);
    return static_cast<snapshot::Codec>(std::clamp(hello.codec, 1u, highest));
}

}  // namespace

SnapshotStream::SnapshotStream(const Parts& parts, const Hello& hello, int divider)
    : parts_(parts),
      codec_(codec_for(hello, parts.context.config.stream)),
      entities_(parts.broadcast, baselines_, parts.outbox,
                hello.packed_entities ? EntityForm::packed : EntityForm::complete),
      schedule_(parts.context.config.stream, parts.broadcast.host().hz(), divider, parts.overload),
      sections_({.context = parts.context,
                 .broadcast = parts.broadcast,
                 .poses = *parts.poses,
                 .entities = entities_,
                 .inputs = parts.inputs,
                 .schedule = schedule_,
                 .client = parts.client,
                 .codec = codec_},
                hello) {
    ASSERT(divider >= 1);
    if (!has_cells()) entities_.record_in(parts.sent_log);
}

FramePtr SnapshotStream::on_enter() {
    WorldHost& host = parts_.broadcast.host();
    sections_.on_enter(host.listeners());
    host.wake();
    FramePtr frame = host.frame();
    events_at_entry_ = frame->events->count;
    if (EventsSection* const events = sections_.events()) events->set_cursor(events_at_entry_);
    messages_at_entry_ = frame->messages->count;
    if (MessagesSection* const messages = sections_.messages())
        messages->set_cursor(messages_at_entry_);
    return frame;
}

std::optional<OutMessage> SnapshotStream::take_message(Clock::time_point now) {
    ASSERT(parts_.outbox.empty());
    const FramePtr newest = parts_.broadcast.host().frame();
    if (newest->tick != schedule_.last_frame()) on_frame(*newest, now);
    schedule_.set_write_blocked(false);
    const FramePtr frame = frame_to_send(newest);
    const bool by_datagram = datagrams_ && datagrams_->carries(frame->tick, now);
    if (!by_datagram && (!schedule_.is_due() || frame->tick <= newest_sent())) return std::nullopt;
    // The snapshot follows in a later call, from the frame that is newest then.
    if (!has_cells() && send_entity_list(frame)) {
        if (std::optional<OutMessage> update = parts_.outbox.pop()) {
            on_other_sent();
            parts_.metrics.sent_other(*update);
            return update;
        }
    }
    if (by_datagram) return make_reply(frame, now);
    return make_snapshot(frame, now);
}

// The frame that made the snapshot due, if it is still fresh: other clients of the class get the
// same one. A client with results gets the newest frame, which contains their effects.
FramePtr SnapshotStream::frame_to_send(const FramePtr& newest) const {
    const std::uint32_t tick = schedule_.is_due() ? schedule_.due_tick() : 0;
    if (tick == 0 || tick >= newest->tick || newest->tick - tick > shared_frame_age_max ||
        !parts_.inputs.results().empty())
        return newest;
    const FramePtr shared = parts_.poses->snapshots().frame(tick);
    return shared && tick > newest_sent() ? shared : newest;
}

bool SnapshotStream::send_entity_list(const FramePtr& frame) {
    if (frame->entity_list == entities_.list()) return false;
    entities_.send_list(frame->entity_list);
    return true;
}

void SnapshotStream::on_frame(const Frame& frame, Clock::time_point now) {
    schedule_.on_frame(frame.tick);
    parts_.inputs.collect_results();
    if (!schedule_.is_due() && has_changes(frame, now)) schedule_.request(now);
    parts_.metrics.on_frame(schedule_);
}

bool SnapshotStream::has_changes(const Frame& frame, Clock::time_point now) {
    // A snapshot sent by datagram may be lost, so its changes count until it is acknowledged.
    const bool by_datagram = datagrams_ && datagrams_->carries(frame.tick, now);
    const std::uint32_t sent = by_datagram ? datagrams_->frames().newest() : baselines_.last();
    return frame.changed_at > sent || sections_.has_changes(frame) || schedule_.heartbeat_due(now);
}

// By stream or by datagram.
std::uint32_t SnapshotStream::newest_sent() const {
    return datagrams_ ? std::max(baselines_.last(), datagrams_->frames().last_sent())
                      : baselines_.last();
}

// Only a world that moves tells whether frames were missed: a frame without changes wakes no
// thread.
void SnapshotStream::measure_send_delay(const Frame& frame, Clock::time_point now) {
    const std::optional<std::uint32_t> missed = schedule_.ticks_missed();
    if (!missed || frame.changed_at != frame.tick || frame.previous_changed_at + 1 < frame.tick)
        return;
    const double frame_age_s =
        std::chrono::duration<double>(std::max(Clock::duration::zero(), now - frame.published))
            .count();
    schedule_.flow().on_send_delay(frame_age_s + *missed / parts_.broadcast.host().hz(), now);
}

std::optional<OutMessage> SnapshotStream::make_snapshot(const FramePtr& frame,
                                                        Clock::time_point now) {
    if (datagrams_)
        if (auto baselines = datagrams_->take_stream_baselines())
            baselines_ = *std::move(baselines);
    ASSERT(frame->tick > baselines_.last());
    // Before the sections, whose data counts as sent.
    SharedBytes shared = has_cells() ? parts_.poses->snapshots().encoding(
                                           frame, baselines_.baselines_for(frame->tick),
                                           sections_.channel_kinds(), std::nullopt)
                                     : encode(frame, baselines_);
    if (!shared) return std::nullopt;
    SnapshotParts parts;
    TrafficBytes traffic{};
    sections_.append_optional(frame, now, parts, traffic);
    sections_.client_update().append(frame, now, parts);
    ASSERT(parts.has_poses == !has_cells());
    ASSERT(parts.channel_kinds == sections_.channel_kinds());
    std::size_t shared_bytes = shared->size();
    for (const SharedBytes& field : parts.shared_fields) shared_bytes += field->size();
    OutMessage message{encode_snapshot_header(parts.update, parts.fields, shared_bytes),
                       std::move(shared), std::move(parts.shared_fields)};
    on_results_sent(frame->tick);
    baselines_.on_sent(frame->tick);
    if (datagrams_) datagrams_->on_sent_by_stream(frame->tick);
    measure_send_delay(*frame, now);
    schedule_.on_sent(frame->tick, now);
    sections_.on_sent(message);
    const std::size_t channels =
        parts.channel_kinds != 0 && message.shared ? channels_size(*message.shared) : 0;
    parts_.metrics.sent_snapshot(message.size(), channels, traffic);
    return message;
}

// Nothing: there is no data that must not be lost.
std::optional<OutMessage> SnapshotStream::make_reply(const FramePtr& frame, Clock::time_point now) {
    SnapshotParts parts;
    TrafficBytes traffic{};
    sections_.append_optional(frame, now, parts, traffic);
    if (parts.fields.empty() && parts.shared_fields.empty() && parts_.inputs.results().empty())
        return std::nullopt;
    sections_.client_update().append(frame, now, parts);
    std::size_t shared_bytes = 0;
    for (const SharedBytes& field : parts.shared_fields) shared_bytes += field->size();
    OutMessage message{encode_snapshot_header(parts.update, parts.fields, shared_bytes), nullptr,
                       std::move(parts.shared_fields)};
    on_results_sent(frame->tick);
    parts_.metrics.sent_update(message.size(), traffic);
    return message;
}

void SnapshotStream::on_results_sent(std::uint32_t tick) {
    EventsSection* const events = sections_.events();
    parts_.metrics.answered(parts_.inputs.results());
    if (parts_.sent_log)
        parts_.sent_log->on_snapshot(tick, parts_.inputs.results(),
                                     events ? events->cursor() : events_at_entry_);
    parts_.inputs.on_results_sent();
}

void SnapshotStream::on_ack(const Ack& ack, Clock::time_point now) {
    schedule_.flow().on_ack(ack.frame, std::chrono::milliseconds(ack.ack_delay_ms), now);
    if (parts_.sent_log) parts_.sent_log->on_ack(ack.frame);
    if (datagrams_) datagrams_->on_ack(ack.frame, ack.ack_bits, now);
    if (!ack.need_keyframe || now - keyframe_requested_ < keyframe_period) return;
    keyframe_requested_ = now;
    baselines_.reset();
    if (datagrams_) datagrams_->frames().reset();
    if (sections_.cells()) sections_.cells()->reset();
    if (sections_.points()) sections_.points()->reset();
    if (sections_.players()) sections_.players()->send_complete();
    if (sections_.attributes()) sections_.attributes()->send_complete();
}

Status SnapshotStream::set_interest(const Interest& interest) {
    if (!sections_.cells())
        return Error{ErrorCode::failed_precondition,
                     "interest: the stream has no area of interest; set hello.interest"};
    sections_.cells()->set_interest(interest);
    return {};
}

void SnapshotStream::use_datagrams(DatagramSession& datagrams) {
    // Cells have baselines of their own, which clients do not acknowledge.
    ASSERT(!has_cells());
    datagrams_ = &datagrams;
    sections_.client_update().report_received_inputs();
    entities_.record_in(nullptr);
}

FramePtr SnapshotStream::prepare_datagram(const FramePtr& newest, Clock::time_point now) {
    ASSERT(datagrams_ != nullptr);
    if (newest->tick != schedule_.last_frame()) {
        schedule_.set_write_blocked(false);
        on_frame(*newest, now);
    }
    FramePtr frame = frame_to_send(newest);
    if (!schedule_.is_due() || frame->tick <= datagrams_->frames().last_sent()) return nullptr;
    // The snapshot need not wait for the stream: clients skip entities that they do not know.
    send_entity_list(frame);
    return frame;
}

SharedBytes SnapshotStream::encode(const FramePtr& frame, const BaselineTracker& known) {
    SnapshotCache::Shared shared =
        parts_.poses->snapshots().shared_encoding(frame, known, sections_.channel_kinds(), codec_);
    if (shared.fresh) parts_.metrics.encoded_snapshot();
    if (!shared.bytes) schedule_.defer();
    return std::move(shared.bytes);
}

void SnapshotStream::on_sent_by_datagram(const OutMessage& snapshot, const Frame& frame,
                                         Clock::time_point now) {
    measure_send_delay(frame, now);
    schedule_.on_sent(frame.tick, now);
    parts_.metrics.sent(snapshot, now);
    parts_.metrics.sent_snapshot(snapshot.size(), 0, {});
}

void SnapshotStream::suspend(DisconnectedClient& client) {
    // Acknowledgements of datagrams and cells do not cover what the stream carried.
    client.stream_resumable = !has_cells() && !datagrams_;
    client.baselines = std::move(baselines_);
    client.sent_geometry = entities_.take_geometry();
    client.channel_kinds = sections_.channel_kinds();
    client.precision = poses().precision();
    client.messages_at_entry = messages_at_entry_;
}

// A client of an earlier process that names no message continues with the next one.
void SnapshotStream::resume_messages(std::optional<std::uint32_t> first,
                                     std::uint32_t last_received) {
    const std::uint32_t count = messages_at_entry_;
    messages_at_entry_ = std::min(first.value_or(last_received == 0 ? count : 0), count);
    if (MessagesSection* const messages = sections_.messages())
        messages->set_cursor(std::clamp(last_received, messages_at_entry_, count));
}

bool SnapshotStream::resume(DisconnectedClient& lost, SentLog::Known& known, std::uint32_t frame) {
    ASSERT(parts_.sent_log != nullptr);
    if (has_cells() || !lost.stream_resumable || !known.list ||
        sections_.channel_kinds() != lost.channel_kinds || poses().precision() != lost.precision ||
        !lost.baselines.roll_back_to(frame))
        return false;
    baselines_ = std::move(lost.baselines);
    *parts_.sent_log = std::move(lost.sent);
    parts_.sent_log->roll_back_to(frame);
    for (const std::uint64_t id : known.geometry) lost.sent_geometry.erase(id);
    entities_.resume(std::move(known.list), std::move(lost.sent_geometry));
    if (EventsSection* const events = sections_.events()) events->set_cursor(known.events);
    return true;
}

}  // namespace jostle::server
