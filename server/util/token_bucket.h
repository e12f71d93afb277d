// SPDX-License-Identifier: MIT
//
// A rate limit that allows bursts: tokens refill at a fixed rate up to a maximum.
#pragma once

#include <algorithm>

#include "jostle/base/check.h"
#include "server/util/clock.h"

namespace jostle::server {

class TokenBucket {
public:
    // The burst is one second's worth; the bucket starts full.
    TokenBucket(double per_second, Clock::time_point now)
        : TokenBucket(per_second, per_second, now) {}
    TokenBucket(double per_second, double burst, Clock::time_point now)
        : rate_(per_second), burst_(burst), tokens_(burst), last_(now) {
        ASSERT(per_second >= 0 && burst >= 0);
    }

    // Takes `amount` and returns true, or takes nothing and returns false if there are too few
    // tokens.
    bool take(double amount, Clock::time_point now) {
        ASSERT(amount >= 0);
        refill(now);
        if (tokens_ < amount) return false;
        tokens_ -= amount;
        return true;
    }

    // Takes `amount` even if there are too few tokens; the debt is refilled later.
    void spend(double amount, Clock::time_point now) {
        ASSERT(amount >= 0);
        refill(now);
        tokens_ -= amount;
    }

    // Time until take(amount) can succeed; zero if it can now.
    Clock::duration wait_for(double amount, Clock::time_point now) {
        refill(now);
        if (tokens_ >= amount) return Clock::duration::zero();
        // Rounded up, so that a caller that waits exactly this long succeeds.
        return std::chrono::ceil<std::chrono::milliseconds>(
            from_seconds((amount - tokens_) / rate_ + 1e-6));
    }

private:
    void refill(Clock::time_point now) {
        const double passed = std::chrono::duration<double>(now - last_).count();
        last_ = std::max(last_, now);  // threads may pass times out of order
        tokens_ = std::min(burst_, tokens_ + rate_ * std::max(0.0, passed));
    }

    double rate_, burst_, tokens_;
    Clock::time_point last_;
};

}  // namespace jostle::server
