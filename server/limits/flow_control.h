// SPDX-License-Identifier: MIT
//
// When a client gets its next snapshot. What was sent and not acknowledged waits in buffers on the
// way, and is as old as that queue is long: without a bound they fill for seconds before a write
// ever blocks. The bound is a rate and a window: at first the world's rate and, after a few acks,
// what it has on the way in a round trip, an ack period and a little slack. A queue that does not
// go away within a quarter of a second means that the client takes less: the rate becomes what it
// took, nothing is sent until the queue is gone, and the window shrinks with the rate. A burst, or
// a stall however long, leaves no queue behind and changes nothing. After a pause the rate rises
// again, the window with what is delivered; the pause doubles when this was too much. (The standing
// queue is CoDel's, Nichols and Jacobson 2012; a rate that follows what was delivered is BBR's,
// Cardwell et al. 2016.)
#pragma once

#include <cstdint>

#include "server/config/config.h"
#include "server/util/clock.h"
#include "server/util/fifo.h"

namespace jostle::server {

class FlowControl {
public:
    // `hz`: ticks a second. `divider`: the client asked for every divider-th tick.
    FlowControl(const StreamSettings& settings, double hz, int divider);

    // Whether the snapshot of this tick may go out now. Counts what is left out.
    bool may_send(std::uint32_t tick, Clock::time_point now);
    // A snapshot was handed to the transport.
    void on_sent(std::uint32_t frame, Clock::time_point now);
    // Any other message was: it waits in the same queue.
    void on_other_sent() { others_++; }
    // `held`: between the client's decoding of the frame and its ack.
    void on_ack(std::uint32_t frame, Clock::duration held, Clock::time_point now);

    // Of datagrams: what was sent before and not acknowledged since is lost, and no longer on the
    // way.
    void drop_sent_before(Clock::time_point sent);

    // Messages that may be on the way.
    int window() const;
    int in_flight() const { return in_flight_; }
    double rate() const { return rate_; }  // snapshots a second
    // Snapshots that the window held back.
    std::uint32_t skipped() const { return skipped_; }
    // Snapshots that were not even tried, because the client takes fewer.
    std::uint32_t rate_skipped() const { return rate_skipped_; }
    double round_trip_s() const { return rtt_s_; }  // of the last ack; 0: there was none
    int divider() const { return divider_; }

private:
    struct SentSnapshot {
        std::uint32_t frame;
        Clock::time_point at;
        int messages;  // with those that went before it and are no snapshots
        bool alone;    // nothing else was on the way
    };
    // What acks told since `begun`.
    struct Round {
        Clock::time_point begun{};
        int acks = 0, delivered = 0;
        double queue_s = 0;  // the shortest
    };
    void update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now);
    void update_queue_estimate(const SentSnapshot& flight, double rtt, int delivered,
                               Clock::time_point now);
    void end_round(Clock::time_point now);
    void slow_down(Clock::time_point now);
    void speed_up();

    const StreamSettings settings_;
    const int divider_;
    const double full_rate_;
    double rate_, delivered_rate_ = 0;  // as of the last round
    int window_learned_;                // grows with what is acknowledged; for the first moments
    Fifo<SentSnapshot> sent_snapshots_;
    int in_flight_ = 0, others_ = 0;  // messages; since the last snapshot
    double rtt_s_ = 0, rtt_min_s_ = 0;
    bool measured_ = false;
    Round round_;
    bool emptying_ = false;  // until nothing is on the way, to see how long the way is
    bool probing_ = false;   // by one snapshot alone
    bool limited_ = false;   // the rate was lowered, and not yet seen to be right in full
    bool raised_ = false;    // since then
    Clock::time_point next_send_{}, raise_at_{}, lowered_{}, alone_at_{};
    Clock::duration pause_;  // before the rate is raised
    std::uint32_t skipped_ = 0, rate_skipped_ = 0;
};

}  // namespace jostle::server
