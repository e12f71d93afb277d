// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/play_protocol.h"

#include <algorithm>
#include <iterator>

namespace jostle::client {
namespace {

constexpr std::uint32_t protocol_version = 1;
constexpr auto usual_batch_period = std::chrono::microseconds(33'333);  // 30 batches per second
constexpr int initial_pings = 3;  // at short intervals, for a quick clock estimate
constexpr auto initial_ping_period = std::chrono::milliseconds(100);
constexpr auto ping_period = std::chrono::seconds(1);
// limits of untaken results and ages
constexpr std::size_t results_max = 4096, ages_max = 1u << 16;
constexpr std::size_t events_max = 1024;  // limit of untaken events, in ticks
constexpr std::size_t messages_max = 1024, player_events_max = 1024;  // likewise
constexpr std::uint32_t ack_ms_max = 1000;  // upper bound for the interval from the server
// Intervals of datagrams without content: while datagrams get through, before that is known, and
// after a longer failure.
constexpr auto datagram_keepalive_period = std::chrono::milliseconds(250);
constexpr auto initial_probe_period = std::chrono::milliseconds(50);
constexpr auto probe_period = std::chrono::milliseconds(500);
constexpr auto initial_probe_duration = std::chrono::seconds(2);
// excluding the ack and the numbers of the batch
constexpr std::size_t datagram_inputs_bytes = 1000;
// Inputs that stay unconfirmed for longer are sent over the stream as well.
constexpr auto confirm_timeout = std::chrono::seconds(1);

void write(v1::Interest& to, const AreaOfInterest& from) {
    to.mutable_focus()->set_x(from.x);
    to.mutable_focus()->set_z(from.z);
    to.set_radius(from.radius);
}

void write(v1::Precision& to, const Precision& from) {
    to.set_position(from.position);
    to.set_rotation(from.rotation);
    to.set_far_factor(from.far_factor);
}

v1::Aim* aim_of(v1::Input& input) {
    if (input.has_impulse() && input.impulse().has_aim())
        return input.mutable_impulse()->mutable_aim();
    if (input.has_grab() && input.grab().has_aim()) return input.mutable_grab()->mutable_aim();
    if (input.has_explode() && input.explode().has_aim())
        return input.mutable_explode()->mutable_aim();
    return nullptr;
}

}  // namespace

void PlayProtocol::begin(Clock::time_point now) {
    hello_due_ = true;
    ack_due_ = need_keyframe_ = leave_sent_ = datagram_ack_due_ = blocked_reported_ = false;
    ticket_.reset();
    stats_.datagrams = false;
    pings_sent_ = 0;
    next_ping_ = now;
    if (resume_token_.empty()) start_new_session();
}

// The server counts the inputs of each new client from 1.
void PlayProtocol::start_new_session() {
    buffer_.clear();
    newest_ = {};
    last_message_ = 0;
    clock_ = {};
    inputs_.start_new_session();
}

void PlayProtocol::abandon() {
    inputs_.drop_unsent();
    leaving_ = true;
}

void PlayProtocol::ended(const Status& end) {
    stats_.connected = stats_.datagrams = false;
    ticket_.reset();
    if (end.ok()) return;
    stats_.stream_failures++;
    stats_.last_error = end.error().message;
}

// Only the newest interest is sent, with the next message.
void PlayProtocol::set_interest(const AreaOfInterest& interest) {
    if (!options_.interest) return;
    options_.interest = interest;
    interest_due_ = true;
}

v1::ViewTime PlayProtocol::rendered_time() const {
    return client::rendered_time(newest_, buffer_.clock().render_time_us(), tick_us_);
}

std::vector<SmoothPoints> PlayProtocol::interpolated_points() {
    if (newest_.frame == 0 || tick_us_ <= 0) return {};
    const auto after_us = static_cast<double>(buffer_.clock().render_time_us() - newest_.due_us);
    return view_.points().sample(newest_.frame + after_us / tick_us_, 1e6 / tick_us_);
}

std::uint32_t PlayProtocol::send(v1::Input input) {
    if (v1::Aim* aim = aim_of(input);
        aim && !aim->has_view_time() && options_.attach_view_time && newest_.frame != 0)
        *aim->mutable_view_time() = rendered_time();
    return inputs_.push(std::move(input));
}

void PlayProtocol::receive(const std::string& bytes, Clock::time_point now) {
    stats_.bytes_received += bytes.size();
    if (options_.on_message) options_.on_message(bytes, now);
    if (!message_.ParseFromString(bytes)) {
        stats_.decode_errors++;
        stats_.last_error = "received bytes that are not a ServerMessage";
        return;
    }
    if (message_.has_welcome() && options_.datagrams) ticket_received_at_ = now;
    on_message(now);
}

void PlayProtocol::receive_datagram(const std::string& bytes, Clock::time_point now) {
    stats_.bytes_received += bytes.size();
    if (options_.on_message) options_.on_message(bytes, now);
    if (!message_.ParseFromString(bytes) || !message_.has_snapshot()) {
        stats_.decode_errors++;
        stats_.last_error = "received a datagram without a snapshot";
        return;
    }
    const std::uint64_t before = stats_.snapshots;
    on_message(now);
    stats_.datagram_snapshots += stats_.snapshots - before;
}

void PlayProtocol::note_error(const Status& applied) {
    if (applied.ok()) return;
    stats_.decode_errors++;
    stats_.last_error = applied.error().message;
}

void PlayProtocol::on_message(Clock::time_point now) {
    switch (message_.message_case()) {
        case v1::ServerMessage::kWelcome:
            on_welcome(message_.welcome(), now);
            break;
        case v1::ServerMessage::kGeometry:
            note_error(view_.apply(message_.geometry()));
            break;
        case v1::ServerMessage::kEntityUpdate:
            note_error(view_.apply(message_.entity_update()));
            break;
        case v1::ServerMessage::kSnapshot:
            if (message_.snapshot().has_controlled_entity())
                // A malformed state is not predicted.
                static_cast<void>(view_.apply(message_.snapshot().controlled_entity()).ok());
            if (message_.snapshot().frame() != 0) on_snapshot(message_.snapshot(), now);
            on_points(message_.snapshot());
            if (message_.snapshot().has_joints())
                note_error(view_.apply(message_.snapshot().joints()));
            on_data(*message_.mutable_snapshot());
            inputs_.confirm(message_.snapshot().client_update().input_received(), now);
            // Results and events are independent of the poses.
            on_results(message_.snapshot().client_update(), now);
            if (message_.snapshot().has_stats()) world_stats_ = message_.snapshot().stats();
            for (v1::Events& events : *message_.mutable_snapshot()->mutable_events())
                on_events(std::move(events));
            break;
        case v1::ServerMessage::kPong:
            clock_.add(message_.pong().client_time_us(), message_.pong().server_time_us(),
                       to_us(now));
            stats_.rtt_ms = clock_.rtt_ms();
            break;
        case v1::ServerMessage::kNotice:
            stats_.last_error = message_.notice().message();
            break;
        case v1::ServerMessage::MESSAGE_NOT_SET:
            break;  // of a newer server; ignored
    }
}

void PlayProtocol::on_welcome(const v1::Welcome& welcome, Clock::time_point now) {
    if (welcome.resumed())
        inputs_.resume_after(welcome.last_sequence(), now);
    else if (!resume_token_.empty())
        start_new_session();
    stats_.resumed += welcome.resumed() ? 1 : 0;
    resume_token_ = welcome.resume_token();
    if (welcome.state_preserved()) {
        view_.resume(welcome);
    } else {
        view_.begin(welcome);
        buffer_.clear();
        newest_ = {};
        input_clock_.begin(welcome.tick_hz());
    }
    tick_us_ = 1e6 / std::clamp(welcome.tick_hz(), 1.0, 1e5);
    stats_.connected = true;
    stats_.client_id = welcome.client_id();
    ack_period_ =
        std::chrono::milliseconds(std::min<std::uint32_t>(welcome.ack_interval_ms(), ack_ms_max));
    if (options_.datagrams && welcome.has_datagrams()) ticket_ = welcome.datagrams();
    inputs_.retain_until_confirmed(ticket_.has_value() || !resume_token_.empty());
}

void PlayProtocol::set_datagrams(bool alive, bool timed_out) {
    if (!alive && !blocked_reported_ && (stats_.datagrams || timed_out)) {
        blocked_reported_ = true;
        stats_.last_error = "no datagrams received; using the stream";
    }
    if (alive) blocked_reported_ = false;
    // Acks sent by datagram may be lost, and the server waits for them.
    if (!alive && stats_.datagrams) ack_due_ = true;
    stats_.datagrams = alive;
}

void PlayProtocol::datagrams_failed(const Error& reason) {
    ticket_.reset();
    stats_.datagrams = false;
    stats_.last_error = reason.message;
}

void PlayProtocol::on_snapshot(const v1::Snapshot& snapshot, Clock::time_point now) {
    // Datagrams overtake the stream and each other.
    if (ticket_ && snapshot.frame() <= view_.frame().frame) {
        stats_.stale_snapshots++;
        return;
    }
    if (const Status applied = view_.apply(snapshot); !applied.ok()) {
        // While a keyframe is in transit, the following snapshots cannot be decoded either; one
        // error is enough.
        if (!need_keyframe_) {
            stats_.decode_errors++;
            stats_.last_error = applied.error().message;
        }
        need_keyframe_ = ack_due_ = datagram_ack_due_ = true;
        return;
    }
    decoded_at_ = now;
    need_keyframe_ = false;
    ack_due_ = datagram_ack_due_ = true;
    stats_.snapshots++;
    const WorldView::SnapshotTimes times = view_.times_of(snapshot);
    newest_ = {snapshot.frame(), times.due_us};
    if (times.unchanged_until_us) buffer_.hold(*times.unchanged_until_us);
    buffer_.add(view_.rendered_frame(), times.due_us, static_cast<std::int64_t>(to_us(now)),
                times.unchanged_until_us.has_value());
    if (!clock_.ready()) return;
    const auto age_us = static_cast<double>(clock_.server_us(now) - times.due_us);
    adjust_input_clock(snapshot, age_us, now);
    if (ages_ms_.size() < ages_max) ages_ms_.push_back(static_cast<float>(age_us / 1000));
}

// They arrive over the stream only, so they are not stale even if the poses are.
void PlayProtocol::on_points(const v1::Snapshot& snapshot) {
    const bool requested = view_.points().needs_keyframe();
    if (const Status applied = view_.apply_points(snapshot); !applied.ok() && !requested) {
        stats_.decode_errors++;
        stats_.last_error = applied.error().message;
    }
    if (view_.points().needs_keyframe()) ack_due_ = true;
}

void PlayProtocol::adjust_input_clock(const v1::Snapshot& snapshot, double age_us,
                                      Clock::time_point now) {
    input_clock_.on_frame(snapshot.frame(), age_us, 1000 * clock_.rtt_ms() / 2,
                          static_cast<std::int64_t>(to_us(now)));
    input_clock_.on_margin(snapshot.client_update().input_sequence(),
                           snapshot.client_update().input_margin_us());
    stats_.input_margin_ms = input_clock_.margin_ms();
}

void PlayProtocol::on_results(const v1::ClientUpdate& own, Clock::time_point now) {
    for (const v1::InputResult& result : own.results()) {
        if (!inputs_.on_result(result.sequence(), now)) continue;
        if (result.code() == v1::INPUT_CODE_APPLIED)
            stats_.inputs_applied++;
        else
            stats_.inputs_refused++;
        results_.push_back(result);
        if (results_.size() > results_max) results_.pop_front();
    }
}

std::vector<v1::InputResult> PlayProtocol::take_results() {
    std::vector<v1::InputResult> taken(std::make_move_iterator(results_.begin()),
                                       std::make_move_iterator(results_.end()));
    results_.clear();
    return taken;
}

void PlayProtocol::on_events(v1::Events&& events) {
    events_.push_back(std::move(events));
    if (events_.size() <= events_max) return;
    const std::uint32_t lost = events_.front().missed() + 1;
    events_.pop_front();
    events_.front().set_missed(events_.front().missed() + lost);
}

std::vector<v1::Events> PlayProtocol::take_events() {
    std::vector<v1::Events> taken(std::make_move_iterator(events_.begin()),
                                  std::make_move_iterator(events_.end()));
    events_.clear();
    return taken;
}

// They arrive over the stream only and in order.
void PlayProtocol::on_data(v1::Snapshot& snapshot) {
    view_.apply_data(snapshot);
    stats_.messages_missed += snapshot.messages_missed();
    for (v1::UserMessage& message : *snapshot.mutable_messages()) {
        last_message_ = message.number();
        stats_.messages_received++;
        messages_.push_back(std::move(message));
        if (messages_.size() > messages_max) messages_.pop_front();
    }
    for (v1::PlayerUpdate& update : *snapshot.mutable_players())
        for (v1::PlayerEvent& event : *update.mutable_events()) {
            player_events_.push_back(std::move(event));
            if (player_events_.size() > player_events_max) player_events_.pop_front();
        }
}

std::vector<v1::UserMessage> PlayProtocol::take_messages() {
    std::vector<v1::UserMessage> taken(std::make_move_iterator(messages_.begin()),
                                       std::make_move_iterator(messages_.end()));
    messages_.clear();
    return taken;
}

std::vector<v1::PlayerEvent> PlayProtocol::take_player_events() {
    std::vector<v1::PlayerEvent> taken(std::make_move_iterator(player_events_.begin()),
                                       std::make_move_iterator(player_events_.end()));
    player_events_.clear();
    return taken;
}

void PlayProtocol::fill_ack(v1::Ack& ack, Clock::time_point now) {
    ack.set_frame(view_.frame().frame);
    ack.set_need_keyframe(needs_keyframe() || keyframe_requested_);
    if (decoded_at_ != Clock::time_point{})
        ack.set_ack_delay_ms(static_cast<std::uint32_t>(
            std::chrono::duration_cast<std::chrono::milliseconds>(now - decoded_at_).count()));
    if (ticket_) ack.set_ack_bits(view_.ack_bits());
    ack_due_ = datagram_ack_due_ = keyframe_requested_ = false;
    last_ack_ = now;
}

std::string PlayProtocol::take_inputs(Clock::time_point now) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    stats_.inputs_sent += inputs_.take_for_stream(batch);
    input_clock_.sent(inputs_.last_sent());
    fill_ack(*batch.mutable_ack(), now);
    batch.set_client_time_us(static_cast<std::uint32_t>(to_us(now)));
    last_batch_ = now;
    return message.SerializeAsString();
}

std::string PlayProtocol::hello() {
    hello_due_ = interest_due_ = false;
    v1::ClientMessage message;
    v1::Hello& hello = *message.mutable_hello();
    hello.set_protocol(protocol_version);
    hello.set_world(options_.world);
    hello.set_ticket(options_.ticket);
    hello.set_join_code(options_.join_code);
    hello.set_name(options_.name);
    hello.set_snapshot_hz(options_.snapshot_hz);
    hello.set_spectator(options_.spectator);
    hello.set_events(options_.events);
    hello.set_codec(options_.codec);
    for (const std::string& kind : options_.channels) hello.add_channels(kind);
    hello.set_max_kbps(options_.max_kbps);
    hello.set_packed_entities(options_.packed_entities);
    hello.set_joints(options_.joints);
    hello.set_datagrams(options_.datagrams && !options_.network_conditions.impaired());
    if (options_.interest) write(*hello.mutable_interest(), *options_.interest);
    if (options_.precision) write(*hello.mutable_precision(), *options_.precision);
    hello.set_players(options_.players);
    hello.set_attributes(options_.attributes);
    hello.set_room(options_.room);
    for (const std::string& topic : options_.topics) hello.add_topics(topic);
    if (options_.color) hello.set_color(*options_.color);
    hello.set_resumable(options_.resume && options_.reconnect);
    if (!resume_token_.empty()) {
        hello.mutable_resume()->set_token(resume_token_);
        hello.mutable_resume()->set_frame(view_.frame().frame);
        hello.mutable_resume()->set_message(last_message_);
    }
    return message.SerializeAsString();
}

// Inputs are sent by datagram until they are confirmed. They use the stream if datagrams fail or
// the inputs exceed a datagram.
bool PlayProtocol::sends_inputs_on_stream(Clock::time_point now) const {
    if (!inputs_.has_for_stream()) return false;
    return leaving_ || !stats_.datagrams || !inputs_.fits(datagram_inputs_bytes) ||
           inputs_.is_stalled(confirm_timeout, now);
}

// Timed inputs are sent at once, but several of one tick share a batch.
Clock::duration PlayProtocol::batch_period() const {
    if (!inputs_.has_unsent_timed()) return usual_batch_period;
    const auto half_tick = std::chrono::microseconds(static_cast<std::int64_t>(tick_us_ / 2));
    return std::min<Clock::duration>(usual_batch_period, half_tick);
}

std::optional<std::string> PlayProtocol::take_message(Clock::time_point now) {
    if (hello_due_) return hello();
    if (!stats_.connected || leave_sent_) return std::nullopt;
    v1::ClientMessage message;
    if (sends_inputs_on_stream(now) && now - last_batch_ >= batch_period()) return take_inputs(now);
    if (now >= next_ping_) {
        next_ping_ = now + (++pings_sent_ < initial_pings ? Clock::duration(initial_ping_period)
                                                          : Clock::duration(ping_period));
        message.mutable_ping()->set_client_time_us(to_us(now));
        return message.SerializeAsString();
    }
    if (interest_due_) {
        interest_due_ = false;
        write(*message.mutable_interest(), *options_.interest);
        return message.SerializeAsString();
    }
    if (keyframe_requested_ || (ack_due_ && (needs_keyframe() || now - last_ack_ >= ack_period_))) {
        fill_ack(*message.mutable_ack(), now);
        return message.SerializeAsString();
    }
    // The Leave follows the last input.
    if (leaving_ && !inputs_.has_for_stream()) {
        leave_sent_ = true;
        resume_token_.clear();
        message.mutable_leave();
        return message.SerializeAsString();
    }
    return std::nullopt;
}

std::string PlayProtocol::datagram_with_inputs(Clock::time_point now) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    stats_.inputs_sent += inputs_.take_for_datagram(batch, now);
    input_clock_.sent(inputs_.last_sent());
    fill_ack(*batch.mutable_ack(), now);
    batch.set_client_time_us(static_cast<std::uint32_t>(to_us(now)));
    return message.SerializeAsString();
}

std::optional<std::string> PlayProtocol::take_datagram(Clock::time_point now) {
    if (!ticket_ || !stats_.connected || leave_sent_) return std::nullopt;
    const bool through = stats_.datagrams;
    const bool inputs = through && !leaving_ && inputs_.has_unconfirmed() &&
                        inputs_.fits(datagram_inputs_bytes) &&
                        now - last_datagram_batch_ >= batch_period();
    const Clock::duration period = through ? datagram_keepalive_period
                                   : now - ticket_received_at_ < initial_probe_duration
                                       ? initial_probe_period
                                       : probe_period;
    if (!inputs && !(through && datagram_ack_due_) && now - last_datagram_ < period)
        return std::nullopt;
    last_datagram_ = now;
    if (inputs) {
        last_datagram_batch_ = now;
        return datagram_with_inputs(now);
    }
    // The datagram may be lost, so flags that require delivery stay set for the stream.
    const bool ack_due = ack_due_ && !through, keyframe_requested = keyframe_requested_;
    const Clock::time_point last_ack = last_ack_;
    v1::ClientMessage message;
    fill_ack(*message.mutable_ack(), now);
    ack_due_ = ack_due;
    keyframe_requested_ = keyframe_requested;
    if (!through) last_ack_ = last_ack;
    return message.SerializeAsString();
}

}  // namespace jostle::client
