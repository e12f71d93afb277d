// SPDX-License-Identifier: MIT
//
// Decides when a client gets its next snapshot. Unacknowledged data waits in buffers along the path
// and ages with the length of the queue; without a limit the buffers fill for seconds before a
// write ever blocks. The limits are a rate and a window. The rate starts at the world's rate. After
// a few acks the window covers a round trip, an ack interval and a little slack at that rate. A
// queue that stands for a quarter of a second means that the client is slower: the rate becomes the
// delivered rate, nothing is sent until the queue is gone, and the window shrinks with the rate. A
// burst, or a stall of any length, leaves no queue behind and changes nothing. After a pause the
// rate rises again, and the window with the delivered rate; the pause doubles if the rise was too
// much. A client that has not acknowledged although it must, and to which nothing was sent since,
// gets a single snapshot, then others after growing pauses: clients that look at their clock only
// when a snapshot arrives would otherwise wait for the server while it waits for them. (As TCP's
// persist timer: RFC 9293, 3.8.6.1. Standing queue: CoDel, Nichols and Jacobson 2012. Rate from
// delivery: BBR, Cardwell et al. 2016.)
#pragma once

#include <cstdint>

#include "server/config/config.h"
#include "server/util/clock.h"
#include "server/util/fifo.h"

namespace jostle::server {

class FlowControl {
public:
    // `hz`: ticks per second. `divider`: the client requested every divider-th tick.
    FlowControl(const StreamSettings& settings, double hz, int divider);

    // Whether the snapshot of this tick may be sent now. Counts skipped snapshots.
    bool may_send(std::uint32_t tick, Clock::time_point now);
    // A snapshot was passed to the transport.
    void on_sent(std::uint32_t frame, Clock::time_point now);
    // Another message was passed to the transport; it waits in the same queue.
    void on_other_sent() { others_++; }
    // `ack_delay`: time between the client's decoding of the frame and its ack.
    void on_ack(std::uint32_t frame, Clock::duration ack_delay, Clock::time_point now);

    // For datagrams: snapshots sent before `sent` without an acknowledgement are lost and no longer
    // in flight.
    void drop_sent_before(Clock::time_point sent);

    // Maximum number of messages in flight.
    int window() const;
    int in_flight() const { return in_flight_; }
    double rate() const { return rate_; }  // snapshots per second
    // Snapshots skipped because the window was full.
    std::uint32_t skipped() const { return skipped_; }
    // Snapshots skipped because the rate is limited.
    std::uint32_t rate_skipped() const { return rate_skipped_; }
    double round_trip_s() const { return rtt_s_; }  // of the last ack; 0: none yet
    int divider() const { return divider_; }

private:
    struct SentSnapshot {
        std::uint32_t frame;
        Clock::time_point at;
        int messages;  // including other messages sent just before it
        bool alone;    // nothing else was in flight
    };
    // Measurements from acks since `begun`.
    struct Round {
        Clock::time_point begun{};
        int acks = 0, delivered = 0;
        double queue_s = 0;  // minimum
    };
    void update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now);
    void update_queue_estimate(const SentSnapshot& flight, double rtt, int delivered,
                               Clock::time_point now);
    bool probes_silent_client(Clock::time_point now);
    void end_round(Clock::time_point now);
    void slow_down(Clock::time_point now);
    void speed_up();

    const StreamSettings settings_;
    const int divider_;
    const double full_rate_;
    double rate_, delivered_rate_ = 0;  // of the last round
    int window_learned_;                // slow start: grows with acknowledged messages
    Fifo<SentSnapshot> sent_snapshots_;
    int in_flight_ = 0, others_ = 0;  // messages; since the last snapshot
    double rtt_s_ = 0, rtt_min_s_ = 0;
    bool measured_ = false;
    Round round_;
    bool emptying_ = false;  // until nothing is in flight, to measure the base round trip
    bool probing_ = false;   // with a single snapshot in flight
    bool limited_ = false;   // the rate was lowered, and the full rate is not confirmed yet
    bool raised_ = false;    // since the rate was lowered
    Clock::time_point next_send_{}, raise_at_{}, lowered_{}, alone_at_{}, last_sent_{};
    Clock::duration pause_;      // before the rate is raised
    Clock::duration silence_{};  // before the next snapshot for a silent client; 0: not silent
    std::uint32_t skipped_ = 0, rate_skipped_ = 0;
};

}  // namespace jostle::server
