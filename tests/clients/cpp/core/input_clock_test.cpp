// SPDX-License-Identifier: MIT
//
// Inputs of every tick, sent 30 times per second over a simulated network to a server that reports
// their margin over another one. clients/web/sdk/src/clock/input_clock.test.ts has the same test
// cases.
#include "jostle/client/input_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <vector>

#include "jostle/base/network_simulator.h"

namespace jostle::client {
namespace {

constexpr double tick_us = 1e6 / 60;

// Tick n of the server is due at n / 60 s. The local clock differs.
struct SteeredStream {
    explicit SteeredStream(const NetworkConditions& settings) : up(settings), down(settings) {
        clock.begin(60);
    }

    NetworkSimulator up, down;
    InputClock clock;
    std::int64_t us = 3'000'000, next_batch_us = us, batch_period_us = 33'333;
    std::uint32_t sequence = 0, tick = 0;
    double added_way_us = 0;  // additional transit time of inputs
    struct Input {
        std::uint32_t sequence, tick;
    };
    struct Message {
        std::int64_t due_us;
        std::uint32_t sequence;
        double margin_us;
    };
    std::vector<Input> unsent;
    std::deque<Message> coming;
    int late = 0, told = 0;
    double least = 1, greatest = 1;

    // Steps of 1 ms.
    void run(double seconds, double way_us) {
        const auto end = us + static_cast<std::int64_t>(seconds * 1e6);
        for (; us < end; us += 1000) {
            if (us % 16'000 == 0) {
                const double now_tick = std::floor(static_cast<double>(us) / tick_us) - 4;
                clock.on_frame(static_cast<std::uint32_t>(now_tick),
                               static_cast<double>(us) - now_tick * tick_us, way_us, us);
            }
            if (clock.tick(us) > tick) unsent.push_back({++sequence, tick = clock.tick(us)});
            if (us >= next_batch_us && !unsent.empty()) send();
            while (!coming.empty() && coming.front().due_us <= us) {
                clock.on_margin(coming.front().sequence, coming.front().margin_us);
                coming.pop_front();
            }
            least = std::min(least, clock.speed());
            greatest = std::max(greatest, clock.speed());
        }
    }
    void send() {
        next_batch_us = us + batch_period_us;
        const double arrival = static_cast<double>(up.send(us).arrival_us) + added_way_us;
        for (const Input& input : unsent) {
            told++;
            late += input.tick * tick_us < arrival ? 1 : 0;
        }
        const double margin = unsent.back().tick * tick_us - arrival;
        coming.push_back({down.send(static_cast<std::int64_t>(arrival)).arrival_us,
                          unsent.back().sequence, margin});
        clock.sent(unsent.back().sequence);
        unsent.clear();
    }
};

}  // namespace

TEST(InputClock, converges_within_one_tick_of_its_target_with_few_late_inputs) {
    SteeredStream stream({.latency_ms = 50, .jitter_ms = 10});
    stream.run(5, 50'000);
    stream.late = stream.told = 0;
    stream.run(60, 50'000);
    EXPECT_NEAR(stream.clock.margin_ms(), stream.clock.target_ms(), tick_us / 1000);
    RecordProperty("margin_ms", std::to_string(stream.clock.margin_ms()));
    RecordProperty("target_ms", std::to_string(stream.clock.target_ms()));
    RecordProperty("late_share", std::to_string(1.0 * stream.late / stream.told));
    EXPECT_LT(stream.clock.target_ms(), 45) << "one tick plus four times the jitter";
    EXPECT_LT(stream.late, 0.01 * stream.told);
    EXPECT_EQ(stream.clock.jumps(), 0);
}

// The first estimate of the jitter is 4 ms, so that the clock begins 33 ms ahead.
TEST(InputClock, margin_on_loopback_is_one_tick_plus_four_times_the_jitter) {
    SteeredStream stream({.latency_ms = 0.1});
    stream.batch_period_us = 0;  // timed inputs are sent at once
    stream.run(5, 100);
    stream.late = stream.told = 0;
    stream.run(20, 100);
    RecordProperty("margin_ms", std::to_string(stream.clock.margin_ms()));
    RecordProperty("target_ms", std::to_string(stream.clock.target_ms()));
    EXPECT_LT(stream.clock.target_ms(), 22);
    EXPECT_NEAR(stream.clock.margin_ms(), stream.clock.target_ms(), tick_us / 4 / 1000 + 0.5);
    EXPECT_EQ(stream.late, 0);
    EXPECT_EQ(stream.clock.jumps(), 0);
}

TEST(InputClock, adapts_to_a_longer_latency_at_1_05_and_back_at_0_95_speed) {
    SteeredStream stream({.latency_ms = 50});
    stream.run(5, 50'000);
    stream.added_way_us = 100'000;  // six ticks, unknown to the pings
    stream.run(5, 50'000);
    EXPECT_NEAR(stream.clock.margin_ms(), stream.clock.target_ms(), tick_us / 1000);
    stream.added_way_us = 0;
    stream.run(5, 50'000);
    EXPECT_NEAR(stream.clock.margin_ms(), stream.clock.target_ms(), tick_us / 1000);
    EXPECT_EQ(stream.clock.jumps(), 0);
    EXPECT_EQ(stream.least, 0.95);
    EXPECT_EQ(stream.greatest, 1.05);
}

TEST(InputClock, jumps_once_when_more_than_ten_ticks_off) {
    SteeredStream stream({.latency_ms = 50});
    stream.run(5, 50'000);
    stream.added_way_us = 400'000;
    stream.run(5, 250'000);
    EXPECT_EQ(stream.clock.jumps(), 1);
    EXPECT_NEAR(stream.clock.margin_ms(), stream.clock.target_ms(), tick_us / 1000);
}

TEST(InputClock, follows_frames_without_inputs_after_the_server_skips_ticks) {
    InputClock clock;
    EXPECT_EQ(clock.position(5), 0);
    clock.begin(60);
    clock.on_frame(100, 20'000, 50'000, 1'000'000);
    EXPECT_TRUE(clock.ready());
    const double ahead = 70'000 / tick_us + clock.target_ms() * 1000 / tick_us;
    EXPECT_NEAR(clock.position(1'000'000), 100 + ahead, 1e-9);
    EXPECT_NEAR(clock.position(2'000'000), 160 + ahead, 1e-9);
    // One second later on the local clock, half a second later in ticks, without margins for two
    // seconds.
    for (int k = 0; k <= 120; k++) clock.on_frame(130, 20'000, 50'000, 2'000'000);
    EXPECT_NEAR(clock.position(2'000'000), 130 + ahead, 1e-9);
    EXPECT_EQ(clock.jumps(), 1);
}

}  // namespace jostle::client
