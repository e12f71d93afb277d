// SPDX-License-Identifier: MIT
#include "server/session/datagram_transport.h"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>
#include <variant>

#include "server/util/log.h"

namespace jostle::server {

using namespace std::chrono_literals;

namespace {

constexpr std::size_t client_update_bytes_max = 64;  // of the header of a snapshot
constexpr auto lost_after_min = 250ms;

}  // namespace

std::unique_ptr<DatagramTransport> DatagramTransport::open(DatagramServer& server,
                                                           const Parts& parts,
                                                           std::function<void()> wake,
                                                           Welcome& welcome) {
    auto connection = server.open([wake = std::move(wake)](std::string_view message) {
        if (looks_like_inputs(message)) wake();  // other messages wait for the next frame
    });
    if (!connection.ok()) {
        log_warn("client {} uses the stream only: {}", parts.client, connection.error().message);
        return nullptr;
    }
    welcome.datagrams = {.port = server.advertised_port(),
                         .credentials = (*connection)->credentials()};
    return std::make_unique<DatagramTransport>(server, *std::move(connection), parts);
}

DatagramTransport::DatagramTransport(DatagramServer& server,
                                     std::shared_ptr<DatagramConnection> connection,
                                     const Parts& parts)
    : parts_(parts), session_(server, std::move(connection)) {
    parts_.snapshots.use_datagrams(session_);
}

Status DatagramTransport::receive(const DatagramConnection::ReceivedMessage& received,
                                  Clock::time_point now) {
    if (!parts_.inputs.admit_message(received.message.size(), now)) return {};
    Result<ClientMessage> message = decode_client_message(received.message);
    if (!message.ok()) return message.error();
    if (const auto* const ack = std::get_if<Ack>(&*message)) {
        parts_.snapshots.on_ack(*ack, received.at);
        return {};
    }
    auto* const batch = std::get_if<InputBatch>(&*message);
    if (!batch)
        return Error{ErrorCode::failed_precondition,
                     "a datagram must contain an InputBatch or an Ack; send other messages on the "
                     "stream"};
    // Inputs are applied in order: after a gap they wait for the datagram that repeats the lost
    // ones.
    if (batch->first_sequence > parts_.inputs.last_sequence() + 1) batch->inputs.clear();
    if (Status s = parts_.inputs.receive(*batch, parts_.snapshots.last_frame(), received.at);
        !s.ok())
        return s;
    if (batch->ack) parts_.snapshots.on_ack(*batch->ack, received.at);
    return {};
}

void DatagramTransport::send(Clock::time_point now) {
    const FramePtr newest = parts_.host.frame();
    drop_lost(now);
    if (!session_.carries(newest->tick, now)) return;
    const FramePtr frame = parts_.snapshots.prepare_datagram(newest, now);
    if (!frame) return;
    const SharedBytes shared = parts_.snapshots.encode(frame, session_.frames().known());
    if (!shared) return;
    if (!session_.fits(shared->size() + client_update_bytes_max, now)) return;
    const OutMessage message{encode_snapshot_header(client_update(), {}, shared->size()), shared};
    session_.send(message, frame->tick, now);
    parts_.snapshots.on_sent_by_datagram(message, *frame, now);
}

// A snapshot that is not acknowledged within two round trips is lost.
void DatagramTransport::drop_lost(Clock::time_point now) {
    if (!session_.sent_last()) return;
    const Clock::duration timeout = from_seconds(2 * parts_.snapshots.round_trip_s());
    parts_.snapshots.drop_sent_before(now - std::max<Clock::duration>(lost_after_min, timeout));
}

// Each update replaces the previous ones, so any of them may be lost.
ClientUpdate DatagramTransport::client_update() {
    const InputIntake::DatagramResult result = parts_.inputs.take_datagram_result();
    ClientUpdate update{.input_sequence = result.sequence,
                        .echo_client_time_us = parts_.inputs.take_client_time_us()};
    update.input_margin_us = result.margin_us;
    update.input_received = parts_.inputs.confirmed();
    return update;
}

}  // namespace jostle::server
