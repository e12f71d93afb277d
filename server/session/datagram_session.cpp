// SPDX-License-Identifier: MIT
#include "server/session/datagram_session.h"

#include <array>
#include <string_view>
#include <utility>

namespace jostle::server {

namespace {

using namespace std::chrono_literals;

// If the client acknowledges no datagram for this long, the path to the client is blocked.
constexpr auto unacked_max = 1s;
// Time without datagrams after a snapshot that did not fit.
constexpr auto large_pause = 1s;

}  // namespace

bool DatagramSession::carries(std::uint32_t tick, Clock::time_point now) {
    if (unacked_since_ && now - *unacked_since_ > unacked_max) {
        unacked_since_.reset();
        connection_->restart_path_validation();
    }
    return now >= by_stream_until_ && connection_->is_open(now) &&
           frames_.baselines_for(tick).baseline != 0;
}

void DatagramSession::on_ack(std::uint32_t frame, std::uint32_t ack_bits, Clock::time_point now) {
    if (!frames_.on_ack(frame, ack_bits)) return;
    unacked_since_.reset();
    if (frame < last_sent_) unacked_since_ = now;
}

bool DatagramSession::fits(std::size_t bytes, Clock::time_point now) {
    if (bytes <= fragments_max * datagram::fragment_bytes) return true;
    by_stream_until_ = now + large_pause;
    return false;
}

void DatagramSession::send(const OutMessage& snapshot, std::uint32_t frame, Clock::time_point now) {
    ASSERT(frame > last_sent_);
    ASSERT(snapshot.shared_fields.empty());
    const std::string_view shared = snapshot.shared ? *snapshot.shared : std::string_view();
    const std::array pieces{std::string_view(snapshot.header), shared};
    connection_->send(pieces, now);
    frames_.on_sent(frame, true);
    last_sent_ = frame;
    if (!unacked_since_) unacked_since_ = now;
    after_datagram_ = true;
}

void DatagramSession::on_sent_by_stream(std::uint32_t frame) {
    frames_.on_sent(frame, false);
}

std::optional<BaselineTracker> DatagramSession::take_stream_baselines() {
    if (!std::exchange(after_datagram_, false)) return std::nullopt;
    return frames_.known();
}

}  // namespace jostle::server
