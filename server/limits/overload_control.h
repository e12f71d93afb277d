// SPDX-License-Identifier: MIT
//
// Tells an overloaded server apart from slow clients. Each network thread has one. A thread that
// cannot send the snapshots of a tick before the next ones are due would serve the clients at the
// end of its round late, and each of them would seem slow. Instead, all clients of the thread are
// served in a slower cadence class (cadence.h), by the same number of classes, until the thread
// keeps up. The time from the publication of a frame to its last snapshot hardly depends on the
// class, so the same measurement tells whether a faster class would fit.
//
// Used on one thread.
#pragma once

#include "server/util/clock.h"

namespace jostle::server {

class OverloadControl {
public:
    // A snapshot was passed to the transport. `delay_s`: time since its frame was published, and
    // since an earlier frame if that one was skipped. `interval_s`, `faster_interval_s`: between
    // snapshots of the client's class, and of the next faster one.
    void on_sent(double delay_s, double interval_s, double faster_interval_s,
                 Clock::time_point now);

    // Number of classes by which all clients are served slower; 0: the thread keeps up.
    int level() const { return level_; }
    // Recent delay of the slowest snapshots, s. Acknowledgements are late by about as much.
    double send_delay_s() const { return send_delay_s_; }

private:
    // Snapshots of one evaluation period.
    struct Period {
        Clock::time_point begun{};
        int sent = 0, late = 0, late_for_faster = 0;
        double delay_s = 0;  // maximum
    };
    void evaluate(Clock::time_point now);

    Period period_;
    int level_ = 0;
    int late_periods_ = 0;  // successive ones
    double send_delay_s_ = 0;
};

}  // namespace jostle::server
