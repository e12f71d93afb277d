// SPDX-License-Identifier: MIT
#include "tools/network_emulator/path_emulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace jostle::network_emulator {
namespace {

using namespace std::chrono_literals;

const Clock::time_point start = Clock::time_point(1000s);

double ms(Clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
}

// Delays of `count` pieces of 1 kB, one per millisecond.
std::vector<double> delays_of(const NetworkConditions& settings, int count,
                              std::uint64_t stream = 0) {
    PathEmulator path(settings, stream, start);
    std::vector<double> delays;
    for (int k = 0; k < count; k++) {
        const auto now = start + k * 1ms;
        delays.push_back(ms(path.arrival_time(1000, now) - now));
    }
    return delays;
}

}  // namespace

TEST(PathEmulator, keeps_delay_and_jitter_in_range_without_reordering) {
    PathEmulator path({.delay_ms = 30, .jitter_ms = 20}, 0, start);
    Clock::time_point last = start;
    double sum = 0;
    for (int k = 0; k < 1000; k++) {
        const auto now = start + k * 100ms;  // too far apart to queue
        const auto at = path.arrival_time(1000, now);
        ASSERT_GE(at, last);
        last = at;
        const double delay = ms(at - now);
        ASSERT_GE(delay, 30);
        ASSERT_LE(delay, 50);
        sum += delay;
    }
    EXPECT_NEAR(sum / 1000, 40, 1) << "uniform from 30 to 50";
}

TEST(PathEmulator, limits_throughput_to_the_configured_rate) {
    // One piece arrives every millisecond and takes eight: the delay grows by seven per piece.
    const auto delays = delays_of({.kbit_per_second = 1000}, 100);
    for (int k = 0; k < 100; k++)
        EXPECT_NEAR(delays[static_cast<std::size_t>(k)], 8 + 7 * k, 1e-3) << k;
}

TEST(PathEmulator, stalls_for_the_configured_share_of_time) {
    // On average 1 s without a stall, then a stall of 200 ms.
    const auto delays = delays_of({.stall_every_s = 1, .stall_ms = 200}, 200'000);
    const auto held = std::count_if(delays.begin(), delays.end(), [](double d) { return d > 0; });
    EXPECT_NEAR(static_cast<double>(held) / 200'000, 1.0 / 6, 0.03);
    EXPECT_LE(*std::max_element(delays.begin(), delays.end()), 200);
    EXPECT_GT(*std::max_element(delays.begin(), delays.end()), 195);
}

TEST(PathEmulator, is_deterministic_per_seed_and_connection) {
    const NetworkConditions settings{.jitter_ms = 20, .stall_every_s = 0.1};
    EXPECT_EQ(delays_of(settings, 1000, 4), delays_of(settings, 1000, 4));
    EXPECT_NE(delays_of(settings, 1000, 4), delays_of(settings, 1000, 5));
    NetworkConditions other = settings;
    other.seed = 2;
    EXPECT_NE(delays_of(settings, 1000, 4), delays_of(other, 1000, 4));
}

TEST(PathEmulator, drops_the_configured_share_of_packets) {
    const Clock::time_point now{};
    PathEmulator lossy({.loss = 0.02}, 3, now), whole({}, 3, now);
    int lost = 0, lost_in_a_row = 0, longest = 0;
    for (int k = 0; k < 100'000; k++) {
        EXPECT_FALSE(whole.drops_packet());
        lost_in_a_row = lossy.drops_packet() ? lost_in_a_row + 1 : 0;
        lost += lost_in_a_row > 0 ? 1 : 0;
        longest = std::max(longest, lost_in_a_row);
    }
    EXPECT_NEAR(lost, 2000, 200);
    EXPECT_LE(longest, 5) << "losses are independent";
}

}  // namespace jostle::network_emulator
