// SPDX-License-Identifier: MIT
//
// Decides what happens to a client that exceeds its message rate. Messages beyond the rate are
// dropped, the client is notified at most once per second, and a client that keeps sending several
// times its rate is disconnected. Used on the session's thread.
#pragma once

#include "server/util/clock.h"

namespace jostle::server {

class FloodGuard {
public:
    // Multiple of the permitted rate at which a notified client is disconnected.
    static constexpr int flood_factor = 5;

    enum class Verdict { drop, notify, disconnect };

    explicit FloodGuard(double messages_per_second) : messages_per_second_(messages_per_second) {}

    // A message exceeded the rate. Every verdict drops it.
    Verdict on_excess(Clock::time_point now);

private:
    const double messages_per_second_;
    int excess_ = 0;  // messages since notified_
    Clock::time_point notified_{};
};

}  // namespace jostle::server
