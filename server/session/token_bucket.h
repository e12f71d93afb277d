// SPDX-License-Identifier: MIT
//
// A rate limit that allows bursts: tokens flow in at a rate up to a store of one second's worth (at
// least one take).
#pragma once

#include <algorithm>

#include "base/clock.h"

namespace jostle::server {

class TokenBucket {
public:
    TokenBucket(double per_second, Clock::time_point now)
        : rate_(per_second), tokens_(per_second), last_(now) {}

    // Takes `amount` when there is that much; otherwise takes nothing and says no.
    bool take(double amount, Clock::time_point now) {
        const double passed = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        tokens_ = std::min(rate_, tokens_ + rate_ * std::max(0.0, passed));
        if (tokens_ < amount) return false;
        tokens_ -= amount;
        return true;
    }

private:
    double rate_, tokens_;
    Clock::time_point last_;
};

}  // namespace jostle::server
