// SPDX-License-Identifier: MIT
//
// Cadence classes: the snapshot rates that the server uses. A client of class c gets every n-th of
// the ticks that it requested; n is a divisor of 60, or 120 or 240. All clients of a class get the
// same ticks, those whose number is a multiple of the class's step, so they have the same baselines
// and share encoded snapshots. A client of its own rate would need its own encodings.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "jostle/base/check.h"

namespace jostle::server {

class Cadence {
public:
    // Beyond the last one a client would get fewer snapshots per second than one, at 240 Hz.
    static constexpr std::array<int, 14> divisors{1,  2,  3,  4,  5,  6,   10,
                                                  12, 15, 20, 30, 60, 120, 240};

    // `hz`: ticks per second. `divider`: the client requested every divider-th tick.
    Cadence(double hz, int divider) : hz_(hz), divider_(std::max(1, divider)) {
        ASSERT(hz > 0);
        while (last_ + 1 < static_cast<int>(divisors.size()) && rate(last_ + 1) >= 1) last_++;
        for (const int divisor : divisors)
            if (divisor <= hz_ / divider_ / changes_per_second) alignment_ = divisor;
    }

    // The slowest class has at least one snapshot per second, unless the client requested fewer.
    int slowest() const { return last_; }
    int clamp(int number) const { return std::clamp(number, 0, last_); }
    std::uint32_t step(int number) const {  // ticks
        return static_cast<std::uint32_t>(divisors[static_cast<std::size_t>(number)] * divider_);
    }
    double rate(int number) const { return hz_ / step(number); }  // snapshots per second
    // The fastest class with at most this rate.
    int class_within(double rate_max) const {
        int number = 0;
        while (number < last_ && rate(number) > rate_max) number++;
        return number;
    }
    // Ticks at which a client may change to a faster class. Clients that change at the same tick
    // share the encodings of the change.
    bool is_aligned(std::uint32_t tick) const {
        return tick % static_cast<std::uint32_t>(alignment_ * divider_) == 0;
    }
    bool is_requested(std::uint32_t tick) const {
        return tick % static_cast<std::uint32_t>(divider_) == 0;
    }
    int divider() const { return divider_; }
    double hz() const { return hz_; }

private:
    static constexpr double changes_per_second = 5;

    double hz_;
    int divider_;
    int last_ = 0, alignment_ = 1;
};

}  // namespace jostle::server
