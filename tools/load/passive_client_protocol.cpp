// SPDX-License-Identifier: MIT
#include "tools/load/passive_client_protocol.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/snapshot/frame_codec.h"
#include "tools/load/data_traffic.h"

namespace jostle::load {

using namespace std::chrono_literals;

namespace {

constexpr std::uint32_t protocol_version = 1;
constexpr int initial_pings = 3;  // at short intervals, for a quick clock estimate
constexpr auto initial_ping_period = 100ms;
constexpr auto ping_period = 5s;
constexpr auto render_period = 16'667us;
// The client library extrapolates for this time beyond the newest snapshot, then it holds.
constexpr std::int64_t extrapolation_max_us = 50'000;
constexpr std::int64_t jump_us = 500'000;  // the rendered time jumped
// Maximum delay of an acknowledgement if the server does not request another one.
constexpr auto default_ack_delay = 150ms;
constexpr int default_ack_every = 6;
constexpr std::uint32_t ack_ms_max = 1000;  // upper bound for the server's value
constexpr std::size_t sent_max = 4096, arrived_max = 128;

template <class Message>
bool parse(Message& message, Bytes bytes) {
    return message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace

PassiveClientProtocol::PassiveClientProtocol(PassiveClientOptions options, LoadMetrics& metrics)
    : options_(std::move(options)),
      metrics_(metrics),
      ack_every_(options_.ack_every > 0 ? options_.ack_every : default_ack_every),
      ack_delay_(default_ack_delay) {
    if (options_.decodes) view_ = std::make_unique<client::WorldView>();
}

// --- receiving ---

void PassiveClientProtocol::receive(Bytes message, Clock::time_point now) {
    metrics_.messages++;
    metrics_.bytes += message.size();
    ProtoFieldReader walk(message);
    for (Field field; walk.next(field);) on_field(field, now);
    if (walk.malformed()) metrics_.add_error("received bytes that are not a ServerMessage");
    if (view_) decode(message);
}

void PassiveClientProtocol::on_field(const Field& field, Clock::time_point now) {
    switch (field.number) {
        case v1::ServerMessage::kWelcomeFieldNumber:
            return on_welcome(field.bytes);
        case v1::ServerMessage::kSnapshotFieldNumber:
            return on_snapshot(field.bytes, now);
        case v1::ServerMessage::kPongFieldNumber:
            return on_pong(field.bytes, now);
        case v1::ServerMessage::kNoticeFieldNumber: {
            v1::Notice notice;
            if (parse(notice, field.bytes)) notice_ = notice.message();
            return;
        }
        default:
            return;
    }
}

void PassiveClientProtocol::on_welcome(Bytes bytes) {
    v1::Welcome welcome;
    if (!parse(welcome, bytes)) return metrics_.add_error("received an invalid Welcome");
    joined_ = true;
    client_id_ = welcome.client_id();
    epoch_us_ = static_cast<std::int64_t>(std::min(welcome.epoch_us(), client::latest_time_us));
    tick_us_ = welcome.tick_hz() > 0 ? 1e6 / std::clamp(welcome.tick_hz(), 1.0, 1e5) : 0;
    if (options_.ack_every == 0 && welcome.ack_interval_ms() > 0) {
        ack_every_ = 0;
        ack_delay_ = std::chrono::milliseconds(std::min(welcome.ack_interval_ms(), ack_ms_max));
    }
}

void PassiveClientProtocol::on_snapshot(Bytes bytes, Clock::time_point now) {
    joined_ = true;  // benchmark servers send no Welcome
    std::uint64_t late = 0;
    Bytes own;
    ProtoFieldReader walk(bytes);
    for (Field field; walk.next(field);) {
        if (field.number == v1::Snapshot::kFrameFieldNumber)
            frame_ = static_cast<std::uint32_t>(field.value);
        if (field.number == v1::Snapshot::kLateUsFieldNumber) late = field.value;
        if (field.number == v1::Snapshot::kClientUpdateFieldNumber) own = field.bytes;
        if (field.number == v1::Snapshot::kMessagesFieldNumber) on_user_message(field.bytes, now);
        if (field.number == v1::Snapshot::kMessagesMissedFieldNumber)
            metrics_.messages_missed += field.value;
    }
    if (walk.malformed()) return metrics_.add_error("received an invalid Snapshot");
    metrics_.snapshots++;
    metrics_.snapshot_bytes += bytes.size();
    unacked_++;
    last_received_ = now;
    if (last_snapshot_)
        metrics_.gap.add(
            std::chrono::duration_cast<std::chrono::microseconds>(now - *last_snapshot_).count());
    last_snapshot_ = now;
    if (options_.decodes && tick_us_ > 0) {
        newest_due_us_ = due_us(frame_, late);
        render_clock_.on_frame(newest_due_us_, static_cast<std::int64_t>(client::to_us(now)));
    }
    if (clock_.ready() && tick_us_ > 0)
        metrics_.add_age(server_us(now) - due_us(frame_, late), now);
    if (!options_.spectator || options_.receives_data) {
        record_effect_delays(frame_, now);
        on_client_update(own, now);
    }
}

void PassiveClientProtocol::on_user_message(Bytes bytes, Clock::time_point now) {
    metrics_.user_messages++;
    ProtoFieldReader walk(bytes);
    for (Field field; walk.next(field);) {
        if (field.number != v1::UserMessage::kDataFieldNumber) continue;
        const std::string_view data(reinterpret_cast<const char*>(field.bytes.data()),
                                    field.bytes.size());
        if (const auto sent = sent_us(data))
            metrics_.message_delay.add(static_cast<std::int64_t>(client::to_us(now) - *sent));
    }
    if (walk.malformed()) metrics_.add_error("received an invalid UserMessage");
}

void PassiveClientProtocol::render(Clock::time_point now) {
    if (newest_due_us_ == 0 || now < next_render_) return;
    next_render_ = std::max(next_render_ + render_period, now);
    const std::int64_t before_us = render_clock_.render_time_us();
    const std::int64_t shown_us =
        render_clock_.advance(static_cast<std::int64_t>(client::to_us(now)));
    metrics_.rendered++;
    const bool is_held = shown_us > newest_due_us_ + extrapolation_max_us;
    metrics_.frozen += is_held || shown_us - before_us > jump_us ? 1 : 0;
}

// See WorldView::times_of(). `late` is zig-zag encoded: 0, -1, 1, -2, ...
std::int64_t PassiveClientProtocol::due_us(std::uint32_t frame, std::uint64_t late) const {
    constexpr auto most = static_cast<std::int64_t>(client::latest_time_us);
    const auto late_us =
        static_cast<std::int64_t>(late >> 1) ^ -static_cast<std::int64_t>(late & 1);
    return epoch_us_ + std::clamp(late_us, -most, most) +
           static_cast<std::int64_t>(std::llround(frame * tick_us_));
}

void PassiveClientProtocol::on_client_update(Bytes bytes, Clock::time_point now) {
    v1::InputResult result;
    ProtoFieldReader walk(bytes);
    for (Field field; walk.next(field);)
        if (field.number == v1::ClientUpdate::kResultsFieldNumber && parse(result, field.bytes))
            on_result(result, now);
    if (walk.malformed()) metrics_.add_error("received invalid input results");
}

// Rejections that valid clients can encounter are not errors: a body that was removed meanwhile, a
// full world.
void PassiveClientProtocol::on_result(const v1::InputResult& result, Clock::time_point now) {
    const bool applied = result.code() == v1::INPUT_CODE_APPLIED;
    metrics_.inputs_applied += applied ? 1 : 0;
    if (result.code() == v1::INPUT_CODE_INVALID || result.code() == v1::INPUT_CODE_NOT_ALLOWED)
        metrics_.add_error(result.message());
    const auto sent = std::find_if(sent_.begin(), sent_.end(), [&](const Sent& input) {
        return input.sequence == result.sequence();
    });
    if (sent == sent_.end()) return;
    const auto us_since_sent = [&](Clock::time_point t) {
        return std::chrono::duration_cast<std::chrono::microseconds>(t - sent->at).count();
    };
    metrics_.result_delay.add(us_since_sent(now));
    if (applied) {
        const auto arrival = std::find_if(arrived_.begin(), arrived_.end(), [&](const Arrival& a) {
            return a.frame >= result.tick();
        });
        if (arrival != arrived_.end())
            metrics_.effect_delay.add(us_since_sent(arrival->at));
        else if (applied_.size() < sent_max)
            applied_.push_back({result.tick(), sent->at});
    }
    sent_.erase(sent);
}

void PassiveClientProtocol::record_effect_delays(std::uint32_t frame, Clock::time_point now) {
    arrived_.push_back({frame, now});
    if (arrived_.size() > arrived_max) arrived_.pop_front();
    std::erase_if(applied_, [&](const Applied& input) {
        if (frame < input.tick) return false;
        metrics_.effect_delay.add(
            std::chrono::duration_cast<std::chrono::microseconds>(now - input.sent).count());
        return true;
    });
}

void PassiveClientProtocol::on_pong(Bytes bytes, Clock::time_point now) {
    v1::Pong pong;
    if (!parse(pong, bytes)) return metrics_.add_error("received an invalid Pong");
    const std::uint64_t sent = pong.client_time_us(), server = pong.server_time_us(),
                        here = client::to_us(now);
    same_clock_ = same_clock_ && sent <= server && server <= here;
    clock_.add(sent, server, here);
}

std::int64_t PassiveClientProtocol::server_us(Clock::time_point now) const {
    return same_clock_ ? static_cast<std::int64_t>(client::to_us(now)) : clock_.server_us(now);
}

void PassiveClientProtocol::decode(Bytes bytes) {
    v1::ServerMessage message;
    if (!parse(message, bytes)) return;  // already counted
    Status applied;
    if (message.has_welcome()) view_->begin(message.welcome());
    if (message.has_geometry()) applied = view_->apply(message.geometry());
    if (message.has_entity_update()) applied = view_->apply(message.entity_update());
    if (message.has_snapshot()) {
        view_->apply_data(message.snapshot());
        applied = view_->apply(message.snapshot());
        metrics_.decoded += applied.ok() ? 1 : 0;
        // While a keyframe is in transit, the following snapshots cannot be decoded either.
        if (std::exchange(need_keyframe_, !applied.ok())) return;
    }
    if (!applied.ok()) metrics_.add_error(applied.error().message);
}

// --- sending ---

std::optional<std::string_view> PassiveClientProtocol::take_message(Clock::time_point now) {
    if (!hello_sent_) {
        hello_sent_ = true;
        v1::Hello& hello = *out_.mutable_hello();
        hello.set_protocol(protocol_version);
        hello.set_world(options_.world);
        hello.set_name(options_.name);
        hello.set_token(options_.token);
        hello.set_spectator(options_.spectator);
        hello.set_max_kbps(options_.max_kbps);
        hello.set_packed_entities(true);
        hello.set_snapshot_hz(options_.snapshot_hz);
        hello.set_players(options_.receives_data);
        hello.set_attributes(options_.receives_data);
        if (options_.receives_data) hello.add_topics(chat_topic);
        // As the clients of players: the cost of the server and the bytes depend on it.
        hello.set_codec(static_cast<std::uint32_t>(snapshot::newest_codec));
        if (options_.precision) {
            hello.mutable_precision()->set_position(options_.precision->position);
            hello.mutable_precision()->set_rotation(options_.precision->rotation);
            hello.mutable_precision()->set_far_factor(options_.precision->far_factor);
        }
        if (options_.interest) {
            hello.mutable_interest()->mutable_focus()->set_x(options_.interest->x);
            hello.mutable_interest()->mutable_focus()->set_z(options_.interest->z);
            hello.mutable_interest()->set_radius(options_.interest->radius);
        }
        return serialized();
    }
    if (!joined_) return std::nullopt;
    if (batch_.inputs_size() > 0) {
        batch_.set_first_sequence(next_sequence_);
        batch_.set_client_time_us(static_cast<std::uint32_t>(client::to_us(now)));
        for (int k = 0; k < batch_.inputs_size(); k++) sent_.push_back({next_sequence_++, now});
        while (sent_.size() > sent_max) sent_.pop_front();
        metrics_.inputs_sent += static_cast<std::uint64_t>(batch_.inputs_size());
        fill_ack(*batch_.mutable_ack(), now);
        out_.mutable_input()->Swap(&batch_);
        batch_.Clear();
        return serialized();
    }
    if (ack_is_due(now)) {
        fill_ack(*out_.mutable_ack(), now);
        return serialized();
    }
    if (now >= next_ping_) {
        next_ping_ = now + (++pings_ < initial_pings ? Clock::duration(initial_ping_period)
                                                     : Clock::duration(ping_period));
        out_.mutable_ping()->set_client_time_us(client::to_us(now));
        return serialized();
    }
    return std::nullopt;
}

void PassiveClientProtocol::play(const std::vector<v1::Input>& inputs) {
    for (const v1::Input& input : inputs) *batch_.add_inputs() = input;
}

bool PassiveClientProtocol::ack_is_due(Clock::time_point now) const {
    if (unacked_ == 0) return false;
    return need_keyframe_ || (ack_every_ > 0 && unacked_ >= ack_every_) ||
           now - last_ack_ >= ack_delay_;
}

void PassiveClientProtocol::fill_ack(v1::Ack& ack, Clock::time_point now) {
    ack.set_frame(frame_);
    ack.set_need_keyframe(need_keyframe_);
    ack.set_ack_delay_ms(static_cast<std::uint32_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(now - last_received_).count()));
    unacked_ = 0;
    last_ack_ = now;
}

std::string_view PassiveClientProtocol::serialized() {
    out_.SerializeToString(&out_bytes_);
    out_.Clear();
    return out_bytes_;
}

}  // namespace jostle::load
