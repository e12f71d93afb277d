// SPDX-License-Identifier: MIT
#include "session/flow_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jostle::server {
namespace {

constexpr int slowdown_max = 6;  // 60 Hz down to 10
constexpr auto two_hits_within = std::chrono::seconds(1);
constexpr auto clean_before_faster = std::chrono::seconds(5);
constexpr double slack_s = 0.05;  // of the window beyond the round trip
// What snapshots wait for a slow client looks like jitter too, and must not widen its window.
constexpr double jitter_share_max_s = 0.2;

}  // namespace

FlowControl::FlowControl(const StreamSettings& settings, double hz, int divider)
    : settings_(settings),
      hz_(hz),
      divider_(std::max(1, divider)),
      window_(settings.ack_window_min) {
    update_window({});
}

bool FlowControl::may_send(std::uint32_t tick, Clock::time_point now) {
    if (slowdown_ > 1 && clean_since_ != Clock::time_point{} &&
        now - clean_since_ >= clean_before_faster) {
        slowdown_ /= 2;
        clean_since_ = now;
    }
    if (tick % static_cast<std::uint32_t>(divider()) != 0) {
        if (tick % static_cast<std::uint32_t>(divider_) == 0) slowed_++;
        return false;
    }
    if (in_flight() < window_) return true;
    skipped_++;
    hit_window(now);
    return false;
}

void FlowControl::hit_window(Clock::time_point now) {
    clean_since_ = now;
    if (std::exchange(blocked_, true)) return;
    if (last_hit_ != Clock::time_point{} && now - last_hit_ <= two_hits_within &&
        slowdown_ < slowdown_max) {
        slowdown_ = std::min(slowdown_max, slowdown_ * 2);
        last_hit_ = {};
    } else {
        last_hit_ = now;
    }
}

void FlowControl::on_sent(std::uint32_t frame, Clock::time_point now) {
    flights_.push_back({frame, now});
}

void FlowControl::on_ack(std::uint32_t frame, Clock::time_point now) {
    // An ack covers all that was sent before: the stream is ordered. A frame that is not in flight
    // says nothing.
    const auto at = std::find_if(flights_.begin(), flights_.end(),
                                 [&](const Flight& f) { return f.frame == frame; });
    if (at == flights_.end()) return;
    update_window(now - at->at);
    flights_.erase(flights_.begin(), at + 1);
    blocked_ = blocked_ && in_flight() >= window_;
}

void FlowControl::update_window(Clock::duration round_trip) {
    const double rtt = std::chrono::duration<double>(round_trip).count();
    if (rtt > 0) {
        rtt_s_ = rtt;
        // The minimum forgets slowly, so that a route that became longer is believed after a while.
        rtt_min_s_ = measured_ ? std::min(rtt, rtt_min_s_ * 1.001) : rtt;
        jitter_s_ = measured_ ? 0.95 * jitter_s_ + 0.05 * std::abs(rtt - rtt_min_s_) : 0;
        measured_ = true;
    }
    const double seconds = rtt_min_s_ + std::min(2 * jitter_s_, jitter_share_max_s) + slack_s;
    window_ = std::clamp(static_cast<int>(std::ceil(seconds * hz_ / divider())),
                         settings_.ack_window_min, settings_.ack_window_max);
}

}  // namespace jostle::server
