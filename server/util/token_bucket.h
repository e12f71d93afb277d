// SPDX-License-Identifier: MIT
//
// A rate limit that allows bursts: tokens flow in at a rate up to a store.
#pragma once

#include <algorithm>

#include "server/util/clock.h"

namespace jostle::server {

class TokenBucket {
public:
    // A store of one second's worth; full at first.
    TokenBucket(double per_second, Clock::time_point now)
        : TokenBucket(per_second, per_second, now) {}
    TokenBucket(double per_second, double burst, Clock::time_point now)
        : rate_(per_second), burst_(burst), tokens_(burst), last_(now) {}

    // Takes `amount` when there is that much; otherwise takes nothing and says no.
    bool take(double amount, Clock::time_point now) {
        refill(now);
        if (tokens_ < amount) return false;
        tokens_ -= amount;
        return true;
    }

    // Takes `amount` whether it is there or not: what is owed flows in later.
    void spend(double amount, Clock::time_point now) {
        refill(now);
        tokens_ -= amount;
    }

    // How long until take(amount) can succeed; zero: it can now.
    Clock::duration wait_for(double amount, Clock::time_point now) {
        refill(now);
        if (tokens_ >= amount) return Clock::duration::zero();
        // A little more than computed, so that who waits exactly so long is not turned away again.
        return std::chrono::ceil<std::chrono::milliseconds>(
            from_seconds((amount - tokens_) / rate_ + 1e-6));
    }

private:
    void refill(Clock::time_point now) {
        const double passed = std::chrono::duration<double>(now - last_).count();
        last_ = std::max(last_, now);  // threads may come with times out of order
        tokens_ = std::min(burst_, tokens_ + rate_ * std::max(0.0, passed));
    }

    double rate_, burst_, tokens_;
    Clock::time_point last_;
};

}  // namespace jostle::server
