// SPDX-License-Identifier: MIT
//
// Monotonic stopwatch for the profile. The result of a step never depends on it.
#pragma once

#include <chrono>

namespace jostle::physics {

class Timer {
public:
    // Returns the milliseconds since construction or the previous lap.
    double lap_ms() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
        start_ = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace jostle::physics
