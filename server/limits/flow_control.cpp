// SPDX-License-Identifier: MIT
#include "server/limits/flow_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr int window_min = 2, initial_window = 4;
constexpr double slack_s = 0.05;  // added to round trip and ack interval in the window
// A standing queue above these limits means that the client is slow. A slow client is always
// reading one message, so one queued message is acceptable.
constexpr double queue_max_s = 0.04, queue_max_messages = 1;
constexpr auto round_length = std::chrono::milliseconds(250);
constexpr int round_acks = 2;
constexpr double rate_min = 1;
constexpr double below_delivered = 0.95;  // so that the queue drains
constexpr double first_raise = 1.1, next_raise = 1.5;
constexpr auto silence_max = std::chrono::seconds(2);
constexpr auto pause_min = std::chrono::seconds(1), pause_max = std::chrono::seconds(2);
// While a client is slow, the path is drained this often to measure the base round trip again. An
// overestimated base round trip would keep a queue of the same length.
constexpr auto drain_period = std::chrono::seconds(10);
// a client that receives this share of the rate accepts the full rate
constexpr double full_share = 0.8;

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

FlowControl::FlowControl(const StreamSettings& settings, double hz, int divider)
    : settings_(settings),
      divider_(std::max(1, divider)),
      full_rate_(hz / divider_),
      rate_(full_rate_),
      window_learned_(initial_window),
      pause_(pause_min) {}

// While the rate rises, the window follows the delivered rate, which bounds the data that a too
// high rate adds.
int FlowControl::window() const {
    const double window_s = rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + slack_s;
    const double rate = limited_ ? std::min(rate_, delivered_rate_) : rate_;
    const int by_rate = static_cast<int>(std::lround(rate * window_s));
    ASSERT(settings_.ack_window_max >= window_min);
    return std::clamp(std::min(by_rate, window_learned_), window_min, settings_.ack_window_max);
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
    // Only snapshots are acknowledged: if none is in flight, one must be sent.
    const bool open = in_flight_ + others_ < window() && !emptying_ && !probing_;
    if (sent_snapshots_.empty() || open || probes_silent_client(now)) return true;
    skipped_++;
    return false;
}

bool FlowControl::probes_silent_client(Clock::time_point now) {
    if (silence_ == Clock::duration{})
        silence_ = from_seconds(rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + slack_s);
    if (now - last_sent_ <= silence_) return false;
    silence_ = std::min<Clock::duration>(2 * silence_, silence_max);
    return true;
}

void FlowControl::on_sent(std::uint32_t frame, Clock::time_point now) {
    const bool alone = sent_snapshots_.empty() && (others_ == 0 || probing_);
    last_sent_ = now;
    sent_snapshots_.push_back({frame, now, others_ + 1, alone});
    in_flight_ += others_ + 1;
    ASSERT(in_flight_ > 0);
    others_ = 0;
    // Keeps an even pace; a delay of less than one step does not shift later snapshots.
    const Clock::duration step = from_seconds(1 / rate_);
    next_send_ = std::max(next_send_, now - step) + step;
}

void FlowControl::on_ack(std::uint32_t frame, Clock::duration ack_delay, Clock::time_point now) {
    // An ack covers everything sent before, because the stream is ordered. An ack of a frame that
    // is not in flight is ignored.
    const auto at = std::find_if(sent_snapshots_.begin(), sent_snapshots_.end(),
                                 [&](const SentSnapshot& f) { return f.frame == frame; });
    if (at == sent_snapshots_.end()) return;
    silence_ = {};
    const SentSnapshot sent = *at;
    const double rtt = std::max(0.0, seconds(now - sent.at - ack_delay));
    update_round_trip(sent, rtt, now);
    int delivered = 0;
    for (auto flight = sent_snapshots_.begin(); flight <= at; ++flight)
        delivered += flight->messages;
    sent_snapshots_.pop_front(static_cast<std::size_t>(at + 1 - sent_snapshots_.begin()));
    in_flight_ -= delivered;
    ASSERT(in_flight_ >= 0 && (in_flight_ == 0) == sent_snapshots_.empty());
    if (sent_snapshots_.empty()) probing_ = false;

    window_learned_ = std::min(window_learned_ + delivered, settings_.ack_window_max);
    update_queue_estimate(sent, rtt, delivered, now);
}

void FlowControl::drop_sent_before(Clock::time_point sent) {
    while (!sent_snapshots_.empty() && sent_snapshots_.front().at < sent) {
        in_flight_ -= sent_snapshots_.front().messages;
        sent_snapshots_.pop_front();
        ASSERT(in_flight_ >= 0);
    }
    if (sent_snapshots_.empty()) probing_ = false;
}

// Snapshots sent before the rate was lowered carry no information about the new rate.
void FlowControl::update_queue_estimate(const SentSnapshot& flight, double rtt, int delivered,
                                        Clock::time_point now) {
    if (round_.begun == Clock::time_point{} || flight.at <= lowered_) {
        round_ = {.begun = now};  // the delivery time of earlier snapshots is unknown
        return;
    }
    const double queue_s = rtt - rtt_min_s_;
    round_.queue_s = round_.acks == 0 ? queue_s : std::min(round_.queue_s, queue_s);
    round_.acks++;
    ASSERT(delivered > 0);
    round_.delivered += delivered;
    if (now - round_.begun >= round_length && round_.acks >= round_acks) end_round(now);
}

// Other messages in flight add queueing delay: only a snapshot that was alone in flight measures
// the base round trip; every other one gives an upper bound.
void FlowControl::update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now) {
    rtt_s_ = rtt;
    if (flight.alone) alone_at_ = now;
    if (!measured_ || rtt < rtt_min_s_ || flight.alone) rtt_min_s_ = rtt;
    measured_ = true;
}

void FlowControl::end_round(Clock::time_point now) {
    ASSERT(now > round_.begun && round_.acks >= round_acks);
    delivered_rate_ = round_.delivered / seconds(now - round_.begun);
    if (round_.queue_s > std::max(queue_max_s, queue_max_messages / delivered_rate_))
        slow_down(now);
    else if (limited_ && now >= raise_at_)
        speed_up();
    if (limited_ && now - alone_at_ > drain_period) {
        emptying_ = true;
        alone_at_ = now;
    }
    round_ = {.begun = now};
}

void FlowControl::slow_down(Clock::time_point now) {
    // If lowering the rate did not remove the queue, it may be no queue: the path may have become
    // longer.
    emptying_ = (limited_ && !raised_) || alone_at_ == Clock::time_point{};
    pause_ = std::exchange(raised_, false) ? std::min<Clock::duration>(pause_ * 2, pause_max)
                                           : pause_min;
    raise_at_ = now + pause_;
    limited_ = true;
    lowered_ = now;
    rate_ = std::max(rate_min, below_delivered * std::min(rate_, delivered_rate_));
    ASSERT(rate_ >= rate_min);
    // By then the client has read everything in flight except for one round trip's worth.
    const double drain_s = in_flight_ / std::max(delivered_rate_, rate_min) - rtt_min_s_;
    next_send_ = now + from_seconds(std::max(0.0, drain_s));
}

// Raises the rate a little at first to detect a new queue, then quickly. Limiting ends when the
// full rate is delivered.
void FlowControl::speed_up() {
    limited_ = rate_ < full_rate_ || delivered_rate_ < full_share * full_rate_;
    rate_ = std::min(full_rate_, rate_ * (raised_ ? next_raise : first_raise));
    ASSERT(rate_ > 0 && rate_ <= full_rate_);
    raised_ = limited_;
}

}  // namespace jostle::server
