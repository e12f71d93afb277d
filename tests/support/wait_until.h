// SPDX-License-Identifier: MIT
//
// Waits for an effect of another thread.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace jostle::test {

// Returns whether the condition became true within 20 s.
inline bool wait_until(const std::function<bool()>& condition) {
    using namespace std::chrono_literals;
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + 20s; Clock::now() < end; std::this_thread::sleep_for(2ms))
        if (condition()) return true;
    return false;
}

}  // namespace jostle::test
