// SPDX-License-Identifier: MIT
//
// Laps in milliseconds, each from the end of the one before.
#include "physics/src/foundation/timer.h"

#include <gtest/gtest.h>

#include <thread>

namespace jostle::test {
namespace {
using namespace std::chrono;

// A machine may be busy, so a lap is bounded by what a clock around it says.
TEST(Timer, lap_is_the_time_since_the_previous_lap_in_milliseconds) {
    const auto begin = steady_clock::now();
    physics::Timer timer;
    std::this_thread::sleep_for(milliseconds(20));
    const double first = timer.lap_ms();
    EXPECT_GE(first, 20);
    std::this_thread::sleep_for(milliseconds(5));
    const double second = timer.lap_ms();
    EXPECT_GE(second, 5);
    const duration<double, std::milli> around = steady_clock::now() - begin;
    EXPECT_LE(first + second, around.count());
}

}  // namespace
}  // namespace jostle::test
