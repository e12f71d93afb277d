// SPDX-License-Identifier: MIT
#include "server/limits/flow_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jostle::server {
namespace {

constexpr int window_min = 2, window_at_first = 4;
constexpr double slack_s = 0.05;  // of the window beyond round trip and ack period
// What stands for a round and is longer is the client's pace. A slow one is always reading one
// message, so one that waits is none too many.
constexpr double queue_max_s = 0.04, queue_max_messages = 1;
constexpr auto round_length = std::chrono::milliseconds(250);
constexpr int round_acks = 2;
constexpr double rate_min = 1;
constexpr double below_delivered = 0.95;  // so that a queue does not grow again
constexpr double first_raise = 1.1, next_raise = 1.5;
constexpr auto pause_min = std::chrono::seconds(1), pause_max = std::chrono::seconds(2);
// A client that takes less is given a moment without anything on the way so often: a way that was
// taken for longer than it is would keep a queue as long as that.
constexpr auto alone_period = std::chrono::seconds(10);
constexpr double full_share = 0.8;  // who is delivered so much of the rate takes all of it

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

FlowControl::FlowControl(const StreamSettings& settings, double hz, int divider)
    : settings_(settings),
      divider_(std::max(1, divider)),
      full_rate_(hz / divider_),
      rate_(full_rate_),
      window_learned_(window_at_first),
      pause_(pause_min) {}

// While the rate rises the window goes by what arrived: it bounds what a rate that is too high
// adds.
int FlowControl::window() const {
    const double way_s = rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + slack_s;
    const double rate = limited_ ? std::min(rate_, delivered_rate_) : rate_;
    const int wanted = static_cast<int>(std::lround(rate * way_s));
    return std::clamp(std::min(wanted, window_learned_), window_min, settings_.ack_window_max);
}

bool FlowControl::may_send(std::uint32_t tick, Clock::time_point now) {
    if (tick % static_cast<std::uint32_t>(divider_) != 0) return false;
    if (sent_snapshots_.empty() && emptying_) {
        emptying_ = false;
        probing_ = true;
    }
    if (limited_ && now < next_send_) {
        rate_skipped_++;
        return false;
    }
    // Only a snapshot is acknowledged: when none is on the way, one must go.
    const bool open = in_flight_ + others_ < window() && !emptying_ && !probing_;
    if (sent_snapshots_.empty() || open) return true;
    skipped_++;
    return false;
}

void FlowControl::on_sent(std::uint32_t frame, Clock::time_point now) {
    const bool alone = sent_snapshots_.empty() && (others_ == 0 || probing_);
    sent_snapshots_.push_back({frame, now, others_ + 1, alone});
    in_flight_ += others_ + 1;
    others_ = 0;
    // An even pace; what was late by less than a step does not move those that follow.
    const Clock::duration step = from_seconds(1 / rate_);
    next_send_ = std::max(next_send_, now - step) + step;
}

void FlowControl::on_ack(std::uint32_t frame, Clock::duration held, Clock::time_point now) {
    // An ack covers all that was sent before: the stream is ordered. A frame that is not in flight
    // says nothing.
    const auto at = std::find_if(sent_snapshots_.begin(), sent_snapshots_.end(),
                                 [&](const SentSnapshot& f) { return f.frame == frame; });
    if (at == sent_snapshots_.end()) return;
    const SentSnapshot sent = *at;
    const double rtt = std::max(0.0, seconds(now - sent.at - held));
    update_round_trip(sent, rtt, now);
    int delivered = 0;
    for (auto flight = sent_snapshots_.begin(); flight <= at; ++flight)
        delivered += flight->messages;
    sent_snapshots_.pop_front(static_cast<std::size_t>(at + 1 - sent_snapshots_.begin()));
    in_flight_ -= delivered;
    if (sent_snapshots_.empty()) probing_ = false;

    window_learned_ = std::min(window_learned_ + delivered, settings_.ack_window_max);
    update_queue_estimate(sent, rtt, delivered, now);
}

void FlowControl::drop_sent_before(Clock::time_point sent) {
    while (!sent_snapshots_.empty() && sent_snapshots_.front().at < sent) {
        in_flight_ -= sent_snapshots_.front().messages;
        sent_snapshots_.pop_front();
    }
    if (sent_snapshots_.empty()) probing_ = false;
}

// What was sent before the rate was lowered says nothing of the new one.
void FlowControl::update_queue_estimate(const SentSnapshot& flight, double rtt, int delivered,
                                        Clock::time_point now) {
    if (round_.begun == Clock::time_point{} || flight.at <= lowered_) {
        round_ = {.begun = now};  // what came before took no time that is known
        return;
    }
    const double queue_s = rtt - rtt_min_s_;
    round_.queue_s = round_.acks == 0 ? queue_s : std::min(round_.queue_s, queue_s);
    round_.acks++;
    round_.delivered += delivered;
    if (now - round_.begun >= round_length && round_.acks >= round_acks) end_round(now);
}

// Others on the way make a queue: only what was alone says how long the way is, and any how long it
// is at most.
void FlowControl::update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now) {
    rtt_s_ = rtt;
    if (flight.alone) alone_at_ = now;
    if (!measured_ || rtt < rtt_min_s_ || flight.alone) rtt_min_s_ = rtt;
    measured_ = true;
}

void FlowControl::end_round(Clock::time_point now) {
    delivered_rate_ = round_.delivered / seconds(now - round_.begun);
    if (round_.queue_s > std::max(queue_max_s, queue_max_messages / delivered_rate_))
        slow_down(now);
    else if (limited_ && now >= raise_at_)
        speed_up();
    if (limited_ && now - alone_at_ > alone_period) {
        emptying_ = true;
        alone_at_ = now;
    }
    round_ = {.begun = now};
}

void FlowControl::slow_down(Clock::time_point now) {
    // A queue that the last time did not take away may be none: the way became longer.
    emptying_ = (limited_ && !raised_) || alone_at_ == Clock::time_point{};
    pause_ = std::exchange(raised_, false) ? std::min<Clock::duration>(pause_ * 2, pause_max)
                                           : pause_min;
    raise_at_ = now + pause_;
    limited_ = true;
    lowered_ = now;
    rate_ = std::max(rate_min, below_delivered * std::min(rate_, delivered_rate_));
    // What is on the way is read by then, but for what a round trip holds.
    const double drain_s = in_flight_ / std::max(delivered_rate_, rate_min) - rtt_min_s_;
    next_send_ = now + from_seconds(std::max(0.0, drain_s));
}

// A little at first, to see whether a queue comes; then quickly. When the full rate arrives it is
// over.
void FlowControl::speed_up() {
    limited_ = rate_ < full_rate_ || delivered_rate_ < full_share * full_rate_;
    rate_ = std::min(full_rate_, rate_ * (raised_ ? next_raise : first_raise));
    raised_ = limited_;
}

}  // namespace jostle::server
