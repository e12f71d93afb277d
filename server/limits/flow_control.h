// SPDX-License-Identifier: MIT
//
// Decides when a client gets its next snapshot. Unacknowledged data waits in buffers along the path
// and ages with the length of the queue; without a limit the buffers fill for seconds before a
// write ever blocks. The limits are a cadence class (cadence.h) and a window in time.
//
// Window: nothing is sent while a snapshot is unacknowledged for longer than a round trip, an ack
// interval and some slack. The slack covers the measured variation of the round trip, and stalls
// that left no queue behind, such as a retransmission.
//
// Class: a queue that stands for a quarter of a second, or for two round trips, means that the
// client is slower: it gets the fastest class within the delivered rate, and nothing is sent until
// the queue is gone. A burst, or a stall of any length, leaves no queue behind and changes nothing.
// After a pause the client gets faster classes again; the pause doubles if the rise was too much.
// The clients of an overloaded network thread are served in slower classes all together
// (overload_control.h), and the delay of that thread does not count as a queue.
//
// A client that has not acknowledged although it must, and to which nothing was sent since, gets a
// single snapshot, then others after growing pauses: clients that look at their clock only when a
// snapshot arrives would otherwise wait for the server while it waits for them. (As TCP's persist
// timer: RFC 9293, 3.8.6.1. Standing queue: CoDel, Nichols and Jacobson 2012. Rate from delivery:
// BBR, Cardwell et al. 2016. Variation of successive delays: RFC 3550, 6.4.1.)
#pragma once

#include <cstdint>

#include "server/config/config.h"
#include "server/limits/cadence.h"
#include "server/limits/overload_control.h"
#include "server/util/clock.h"
#include "server/util/fifo.h"

namespace jostle::server {

class FlowControl {
public:
    // `hz`: ticks per second. `divider`: the client requested every divider-th tick. `overload`: of
    // the thread that serves the client, and outlives this object; null: it is never overloaded.
    FlowControl(const StreamSettings& settings, double hz, int divider,
                OverloadControl* overload = nullptr);

    // Whether the tick belongs to the client's class.
    bool is_due(std::uint32_t tick) const { return tick % step() == 0; }
    // Ticks between two snapshots of the client's class.
    std::uint32_t step() const { return cadence_.step(served_class()); }
    // Whether the snapshot of this tick may be sent now. Counts skipped snapshots.
    bool may_send(std::uint32_t tick, Clock::time_point now);
    // A snapshot was passed to the transport.
    void on_sent(std::uint32_t frame, Clock::time_point now);
    // How late the thread sent a snapshot: see OverloadControl::on_sent.
    void on_send_delay(double delay_s, Clock::time_point now);
    // Another message was passed to the transport; it waits in the same queue.
    void on_other_sent() { others_++; }
    // `ack_delay`: time between the client's decoding of the frame and its ack.
    void on_ack(std::uint32_t frame, Clock::duration ack_delay, Clock::time_point now);

    // For datagrams: snapshots sent before `sent` without an acknowledgement are lost and no longer
    // in flight.
    void drop_sent_before(Clock::time_point sent);

    // A snapshot may be unacknowledged for this long before nothing more is sent, s.
    double window_s() const;
    int in_flight() const { return in_flight_; }           // messages
    double rate() const { return cadence_.rate(class_); }  // snapshots per second
    int served_class() const;                              // with the overload of the server
    // Snapshots skipped because the window was full.
    std::uint32_t skipped() const { return skipped_; }
    // Snapshots skipped because the client has a slower class than it requested.
    std::uint32_t rate_skipped() const { return rate_skipped_; }
    double round_trip_s() const { return rtt_s_; }  // of the last ack; 0: none yet
    const Cadence& cadence() const { return cadence_; }

private:
    struct SentSnapshot {
        std::uint32_t frame;
        Clock::time_point at;
        int messages;  // including other messages sent just before it
        bool alone;    // nothing else was in flight
    };
    struct Delivered {
        int messages = 0, snapshots = 0;
    };
    // Measurements from acks since `begun`.
    struct Round {
        Clock::time_point begun{};
        int acks = 0;
        Delivered delivered{};
        std::uint32_t skipped = 0;  // before it
        double queue_s = 0;         // minimum
    };
    double thread_delay_s() const { return overload_ ? overload_->send_delay_s() : 0; }
    double slack_s() const;
    double queue_max_s() const;
    Clock::duration round_length() const;
    bool is_open(Clock::time_point now) const;
    void update_round_trip(const SentSnapshot& flight, double rtt, Clock::time_point now);
    void update_stall(double oldest_s, double rtt);
    void update_queue_estimate(const SentSnapshot& flight, double rtt, const Delivered& delivered,
                               Clock::time_point now);
    bool probes_silent_client(Clock::time_point now);
    void end_round(Clock::time_point now);
    void slow_down(Clock::time_point now);
    void speed_up();
    void on_starved_round(Clock::time_point now);
    void lower_class(double rate_max, Clock::time_point now);

    const StreamSettings settings_;
    const Cadence cadence_;
    OverloadControl* const overload_;
    int class_ = 0, next_class_ = 0;  // the next one begins at an aligned tick
    int accepted_class_ = 0;          // the fastest one that the client received without a queue
    int starved_rounds_ = 0;
    double message_rate_ = 0, snapshot_rate_ = 0;  // delivered per second in the last round
    int window_learned_;                           // slow start: grows with acknowledged messages
    Fifo<SentSnapshot> sent_snapshots_;
    int in_flight_ = 0, others_ = 0;  // messages; since the last snapshot
    double rtt_s_ = 0, rtt_min_s_ = 0;
    double variation_s_ = 0;  // mean difference of successive round trips
    int variation_samples_ = 0;
    double stall_s_ = 0;  // longest recent wait for an ack that left no queue behind
    bool measured_ = false;
    Round round_;
    bool emptying_ = false;  // until nothing is in flight, to measure the base round trip
    bool probing_ = false;   // with a single snapshot in flight
    bool limited_ = false;   // the class was lowered, and the full rate is not confirmed yet
    bool raised_ = false;    // since the class was lowered
    Clock::time_point next_send_{}, raise_at_{}, changed_{}, alone_at_{}, last_sent_{};
    Clock::duration pause_;      // before the class is raised
    Clock::duration silence_{};  // before the next snapshot for a silent client; 0: not silent
    std::uint32_t skipped_ = 0, rate_skipped_ = 0;
};

}  // namespace jostle::server
