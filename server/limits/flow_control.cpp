// SPDX-License-Identifier: MIT
#include "server/limits/flow_control.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr int window_min = 2, initial_window = 4;  // messages
// Added to round trip and ack interval in the window; more if the round trip varies.
constexpr double slack_min_s = 0.05, variations_covered = 5, variation_max_s = 0.06;
constexpr int variation_samples_max = 32;
// The window covers a retransmission: TCP notices a loss after a round trip, or after this time.
constexpr double retransmission_s = 0.3;
constexpr double stall_margin = 1.1, stall_decay = 0.99;  // per ack
// A standing queue above these limits means that the client is slow. A slow client is always
// reading one message, so one queued message is acceptable.
constexpr double queue_min_s = 0.04, queue_max_messages = 1;
constexpr double round_min_s = 0.25, round_trips = 2, round_snapshots = 4;
constexpr int round_acks = 3, varying_acks = 6;  // 5: if the round trip varies
// The window rather than the class limits a client that skips snapshots while a part of a message
// waits.
constexpr double starved_queue_messages = 0.3;
constexpr int starved_rounds_max = 3;
constexpr double rate_min = 1;
constexpr double below_delivered = 0.95;  // so that the queue drains
constexpr double next_raise = 1.5;
// A class that was accepted before is given up if less than this share of it was delivered.
constexpr double still_accepted_share = 0.7;
constexpr auto silence_max = std::chrono::seconds(2);
constexpr auto pause_min = std::chrono::seconds(1), pause_max = std::chrono::seconds(2);
// While a client is slow, the path is drained this often to measure the base round trip again. An
// overestimated base round trip would keep a queue of the same length.
constexpr auto drain_period = std::chrono::seconds(10);
// A client that receives this share of its rate accepts the rate. A round may begin or end just
// before a snapshot is delivered.
constexpr double accepted_share = 0.95, rounding_snapshots = 0.5;

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

FlowControl::FlowControl(const StreamSettings& settings, double hz, int divider,
                         OverloadControl* overload)
    : settings_(settings),
      cadence_(hz, divider),
      overload_(overload),
      window_learned_(initial_window),
      pause_(pause_min) {}

int FlowControl::served_class() const {
    return cadence_.clamp(class_ + (overload_ ? overload_->level() : 0));
}

double FlowControl::slack_s() const {
    return std::max(slack_min_s, variations_covered * variation_s_) + thread_delay_s();
}

double FlowControl::window_s() const {
    const double usual = rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + slack_s();
    const double stalled =
        limited_ ? 0 : std::min(stall_margin * stall_s_, usual + rtt_min_s_ + retransmission_s);
    return std::min(std::max(usual, stalled), settings_.ack_window_max_ms / 1000.0);
}

// A limited client gets no slack, and its window follows the delivered rate: a class that is too
// fast adds as little data as possible.
bool FlowControl::is_open(Clock::time_point now) const {
    const int in_flight = in_flight_ + others_;
    if (emptying_ || probing_ || in_flight >= window_learned_) return false;
    if (in_flight < window_min) return true;
    const double usual_s =
        rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + 1 / cadence_.hz() + thread_delay_s();
    const double rate_max = std::min(rate(), next_raise * snapshot_rate_);
    if (limited_ && std::ssize(sent_snapshots_) >= std::lround(rate_max * usual_s)) return false;
    return seconds(now - sent_snapshots_.front().at) < window_s();
}

bool FlowControl::may_send(std::uint32_t tick, Clock::time_point now) {
    if (!cadence_.is_requested(tick)) return false;
    if (next_class_ < class_ && cadence_.is_aligned(tick)) {
        class_ = next_class_;
        changed_ = now;
    }
    if (sent_snapshots_.empty() && emptying_) {
        emptying_ = false;
        probing_ = true;
    }
    if (!is_due(tick) || now < next_send_) {
        rate_skipped_++;
        return false;
    }
    // Only snapshots are acknowledged: if none is in flight, one must be sent.
    if (sent_snapshots_.empty() || is_open(now) || probes_silent_client(now)) return true;
    skipped_++;
    return false;
}

bool FlowControl::probes_silent_client(Clock::time_point now) {
    if (silence_ == Clock::duration{})
        silence_ = from_seconds(rtt_min_s_ + settings_.ack_interval_ms / 1000.0 + slack_s());
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
}

void FlowControl::on_send_delay(double delay_s, Clock::time_point now) {
    if (!overload_) return;
    const int number = served_class();
    overload_->on_sent(delay_s, 1 / cadence_.rate(number),
                       1 / cadence_.rate(std::max(class_, number - 1)), now);
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
    update_stall(seconds(now - sent_snapshots_.front().at), rtt);
    Delivered delivered{.snapshots = static_cast<int>(at + 1 - sent_snapshots_.begin())};
    for (auto flight = sent_snapshots_.begin(); flight <= at; ++flight)
        delivered.messages += flight->messages;
    sent_snapshots_.pop_front(static_cast<std::size_t>(delivered.snapshots));
    in_flight_ -= delivered.messages;
    ASSERT(in_flight_ >= 0 && (in_flight_ == 0) == sent_snapshots_.empty());
    if (sent_snapshots_.empty()) probing_ = false;

    // It stops to grow when it no longer limits.
    if (window_learned_ < 2 * (in_flight_ + delivered.messages))
        window_learned_ += delivered.messages;
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

// Other messages in flight add queueing delay: only a snapshot that was alone in flight measures
// the base round trip; every other one gives an upper bound.
void FlowControl::update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now) {
    // A path that varies has as many shorter round trips as longer ones. A queue that builds up has
    // only longer ones, so these are not counted, nor is a queue that drains.
    if (measured_ && !raised_ && flight.at > changed_) {
        const double change = std::min(2 * std::max(0.0, rtt_s_ - rtt), 2 * variation_max_s);
        variation_samples_ = std::min(variation_samples_ + 1, variation_samples_max);
        variation_s_ += (change - variation_s_) / variation_samples_;
        variation_s_ = std::min(variation_s_, variation_max_s);
    }
    rtt_s_ = rtt;
    if (flight.alone) alone_at_ = now;
    if (!measured_ || rtt < rtt_min_s_ || flight.alone) rtt_min_s_ = rtt;
    measured_ = true;
}

// `oldest_s`: how long the oldest snapshot waited for this ack. If the acknowledged one came
// through without a queue, the wait was a stall.
void FlowControl::update_stall(double oldest_s, double rtt) {
    stall_s_ *= stall_decay;
    if (!limited_ && rtt - rtt_min_s_ <= queue_max_s()) stall_s_ = std::max(stall_s_, oldest_s);
}

double FlowControl::queue_max_s() const {
    return std::max(queue_min_s, variations_covered * variation_s_) + thread_delay_s();
}

Clock::duration FlowControl::round_length() const {
    return from_seconds(
        std::max({round_min_s, round_trips * rtt_min_s_, round_snapshots / rate()}));
}

// Snapshots sent before the class was changed carry no information about the new rate.
void FlowControl::update_queue_estimate(const SentSnapshot& flight, double rtt,
                                        const Delivered& delivered, Clock::time_point now) {
    if (round_.begun == Clock::time_point{} || flight.at <= changed_) {
        // The delivery time of earlier snapshots is unknown.
        round_ = {.begun = now, .skipped = skipped_};
        return;
    }
    const double queue_s = rtt - rtt_min_s_;
    round_.queue_s = round_.acks == 0 ? queue_s : std::min(round_.queue_s, queue_s);
    round_.acks++;
    ASSERT(delivered.snapshots > 0 && delivered.messages >= delivered.snapshots);
    round_.delivered.messages += delivered.messages;
    round_.delivered.snapshots += delivered.snapshots;
    const int acks = variations_covered * variation_s_ > queue_min_s ? varying_acks : round_acks;
    if (now - round_.begun >= round_length() && round_.acks >= acks) end_round(now);
}

void FlowControl::end_round(Clock::time_point now) {
    ASSERT(now > round_.begun && round_.acks >= round_acks);
    const double round_s = seconds(now - round_.begun);
    message_rate_ = round_.delivered.messages / round_s;
    snapshot_rate_ = (round_.delivered.snapshots + rounding_snapshots) / round_s;
    const bool accepted = snapshot_rate_ >= accepted_share * cadence_.rate(served_class());
    if (round_.queue_s > std::max(queue_max_s(), queue_max_messages / message_rate_))
        slow_down(now);
    else if (limited_ && !accepted && skipped_ != round_.skipped &&
             round_.queue_s > starved_queue_messages / message_rate_)
        on_starved_round(now);
    else if (limited_ && accepted && now >= raise_at_)
        speed_up();
    if (limited_ && now - alone_at_ > drain_period) {
        emptying_ = true;
        alone_at_ = now;
    }
    round_ = {.begun = now, .skipped = skipped_};
}

void FlowControl::slow_down(Clock::time_point now) {
    // If lowering the class did not remove the queue, it may be no queue: the path may have become
    // longer.
    emptying_ = (limited_ && !raised_) || alone_at_ == Clock::time_point{};
    limited_ = true;
    lower_class(std::min(rate(), snapshot_rate_), now);
    // By then the client has read everything in flight except for one round trip's worth.
    const double drain_s = in_flight_ / std::max(message_rate_, rate_min) - rtt_min_s_;
    next_send_ = now + from_seconds(std::max(0.0, drain_s));
}

// The window, not the class, determined how much the client received.
void FlowControl::on_starved_round(Clock::time_point now) {
    if (++starved_rounds_ >= starved_rounds_max || raised_) lower_class(snapshot_rate_, now);
}

void FlowControl::lower_class(double rate_max, Clock::time_point now) {
    // The class before the raise may take the whole rate of the client: it left no queue.
    const bool returns =
        raised_ && rate_max >= still_accepted_share * cadence_.rate(accepted_class_);
    pause_ = std::exchange(raised_, false) ? std::min<Clock::duration>(pause_ * 2, pause_max)
                                           : pause_min;
    raise_at_ = now + pause_;
    changed_ = now;
    starved_rounds_ = 0;
    const int within = cadence_.class_within(below_delivered * rate_max);
    class_ = next_class_ = std::max(class_, returns ? std::min(within, accepted_class_) : within);
    accepted_class_ = class_;
}

// Raises the class by one at first to detect a new queue, then quickly, each time after the rate
// was delivered. Limiting ends when the full rate is delivered.
void FlowControl::speed_up() {
    accepted_class_ = class_;
    starved_rounds_ = 0;
    limited_ = class_ > 0;
    int number = std::max(0, class_ - 1);
    if (raised_) number = std::min(number, cadence_.class_within(next_raise * rate()));
    next_class_ = number;
    raised_ = limited_;
}

}  // namespace jostle::server
