// SPDX-License-Identifier: MIT
//
// Monotonic stopwatch for the profile. Never read by anything that decides what a step does.
#pragma once

#include <chrono>

namespace jostle::physics {

class Timer {
public:
    // Milliseconds since construction or the last lap.
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
