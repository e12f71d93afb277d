// SPDX-License-Identifier: MIT
//
// The part of a ClientSession that goes by datagrams (docs/design/datagrams.md): snapshots one way,
// acks and inputs the other. Whatever must not get lost stays with the stream.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "server/messages/server_message.h"
#include "server/session/client_session.h"
#include "server/util/log.h"

namespace jostle::server {

using namespace std::chrono_literals;

namespace {

constexpr std::size_t client_update_bytes_max = 64;  // of a snapshot's head in a datagram
constexpr auto lost_after_min = 250ms;

}  // namespace

// Cells have bases of their own, which nobody acknowledges: who sees a part of a world keeps to the
// stream.
void ClientSession::offer_datagrams(const Hello& hello, Welcome& welcome) {
    if (!hello.datagrams || !context_.datagrams || !peer_.wake || interest_) return;
    auto path = context_.datagrams->open([wake = peer_.wake](std::string_view message) {
        if (looks_like_inputs(message)) wake();  // all else waits for the next frame
    });
    if (!path.ok()) return log_warn("client {}: {}", client_, path.error().message);
    datagrams_ = std::make_unique<DatagramSession>(*context_.datagrams, *path);
    welcome.datagrams = {.port = context_.datagrams->advertised_port(),
                         .credentials = (*path)->credentials()};
}

void ClientSession::take_datagrams(Clock::time_point now) {
    if (!datagrams_ || end_) return;
    for (const DatagramConnection::ReceivedMessage& mail : datagrams_->take_messages()) {
        receive_datagram(mail.message, mail.at, now);
        if (end_) return;
    }
    send_datagram(now);
}

void ClientSession::receive_datagram(std::string_view bytes, Clock::time_point at,
                                     Clock::time_point now) {
    last_received_ = std::max(last_received_, at);
    if (!admission_->admit_message(bytes.size(), now)) return;  // a later one says it again
    Result<ClientMessage> message = decode_client_message(bytes);
    if (!message.ok()) return refuse(message.error(), now);
    if (auto* const batch = std::get_if<InputBatch>(&*message)) {
        // Of one that was lost, a later one says the inputs again; what follows them waits.
        if (batch->first_sequence > last_sequence_ + 1) batch->inputs.clear();
        return on_message(*batch, at);
    }
    if (const auto* const ack = std::get_if<Ack>(&*message)) return on_message(*ack, at);
    refuse(Error{ErrorCode::failed_precondition,
                 "a datagram holds an InputBatch or an Ack; all else goes by the stream"},
           now);
}

bool ClientSession::send_by_datagram(const Frame& frame, Clock::time_point now) {
    return datagrams_ && !end_ && datagrams_->carries(frame.tick, now);
}

void ClientSession::send_datagram(Clock::time_point now) {
    const FramePtr frame = broadcast_->host().frame();
    if (datagrams_->sent_last()) {
        const Clock::duration two_ways = from_seconds(2 * flow_->round_trip_s());
        flow_->drop_sent_before(now - std::max<Clock::duration>(lost_after_min, two_ways));
    }
    if (!send_by_datagram(*frame, now)) return;
    if (frame->tick != last_frame_tick_) {
        write_blocked_ = false;
        on_frame(*frame, now);
    }
    if (!snapshot_due_ || frame->tick <= datagrams_->frames().last_sent()) return;
    // Who knows an entity not yet leaves it out: the snapshot need not wait for the stream.
    if (frame->entity_list != entity_list_) send_entities(frame->entity_list);
    const SharedBytes shared = broadcast_->snapshots().encoding(
        frame, datagrams_->frames().baselines_for(frame->tick), channel_kinds_, codec_);
    if (!datagrams_->fits(shared->size() + client_update_bytes_max, now)) return;
    const OutMessage message{encode_snapshot_header(datagram_client_update(), {}, shared->size()),
                             shared};
    datagrams_->send(message, frame->tick, now);
    snapshot_due_ = false;
    last_snapshot_ = now;
    flow_->on_sent(frame->tick, now);
    metrics_.sent(message, now);
    metrics_.sent_snapshot(message.size());
}

// Numbers of which each makes those before it superfluous, so that any may get lost.
ClientUpdate ClientSession::datagram_client_update() {
    ClientUpdate own{.input_sequence = std::exchange(unsent_sequence_, 0),
                     .echo_client_time_us = std::exchange(client_time_us_, 0)};
    own.input_margin_us = std::exchange(unsent_margin_us_, 0);
    own.input_received = confirmed();
    return own;
}

// What must come exactly once, while snapshots go by datagrams: results, events and statistics, in
// a Snapshot that tells nothing of the world.
std::optional<OutMessage> ClientSession::take_reply(Clock::time_point now) {
    const FramePtr frame = broadcast_->host().frame();
    if (frame->entity_list != entity_list_) {
        send_entities(frame->entity_list);
        if (!outgoing_.empty()) return next_message(now);
    }
    const std::string more =
        take_stats(frame, now) + take_events(*frame) + take_controlled_entity(*frame);
    if (results_.empty() && more.empty()) return std::nullopt;
    OutMessage message{encode_snapshot_header(client_update(), more, 0), nullptr};
    if (resume_session_) sent_log_.on_snapshot(frame->tick, results_, event_cursor_);
    metrics_.answered(results_);
    results_.clear();
    return message;
}

}  // namespace jostle::server
