// SPDX-License-Identifier: MIT
//
// Loops on shared threads: rate, rest, wake, hangs and the end.
#include "server/world/tick_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/world/tick_pool.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::wait_until;

constexpr TickLoop::Settings hundred_hz{.hz = 100, .catch_up_ticks_max = 1000};

// A loop that counts its ticks.
struct CountingLoop {
    std::atomic<int> ticks{0};
    std::atomic<bool> stops{false};
    std::string error;
    TickLoop loop;

    ~CountingLoop() { loop.stop(); }
    void start(const std::shared_ptr<TickPool>& pool, TickLoop::Settings settings,
               TickLoop::Run run) {
        loop.start(
            pool, settings, Clock::now(),
            [this, run](const TickLoop::Tick& tick) {
                ticks++;
                return run(tick);
            },
            [this] { return stops.load(); }, [this](const char* what) { error = what; });
    }
};

bool never_rests(const TickLoop::Tick&) {
    return false;
}

// Half of the rests end within 16 ms after a multiple of 50 ms; without the grid a third would.
TEST(TickLoop, rests_end_at_common_times) {
    const auto pool = std::make_shared<TickPool>(2);
    std::vector<CountingLoop> loops(8);
    std::mutex mutex;
    std::vector<Clock::duration> past;
    std::uint32_t late = 0;
    for (CountingLoop& each : loops) {
        std::this_thread::sleep_for(3ms);
        each.start(pool, {.hz = 100, .catch_up_ticks_max = 100, .rest_ticks = 5},
                   [&](const TickLoop::Tick& tick) {
                       const std::lock_guard lock(mutex);
                       late += tick.late_ticks;
                       if (tick.following >= 4)
                           past.push_back(Clock::now().time_since_epoch() % 50ms);
                       return true;
                   });
    }
    std::this_thread::sleep_for(800ms);
    for (CountingLoop& each : loops) each.loop.stop();
    EXPECT_EQ(late, 0u);
    ASSERT_GE(past.size(), 20u);
    std::ranges::sort(past);
    EXPECT_LT(past[past.size() / 2], 16ms);
}

TEST(TickLoop, many_loops_share_few_threads) {
    const auto pool = std::make_shared<TickPool>(2);
    std::vector<CountingLoop> loops(20);
    const auto begin = Clock::now();
    for (CountingLoop& each : loops) each.start(pool, hundred_hz, never_rests);
    std::this_thread::sleep_for(300ms);
    for (CountingLoop& each : loops) each.loop.stop();
    const double due = 100 * std::chrono::duration<double>(Clock::now() - begin).count();
    for (CountingLoop& each : loops) {
        EXPECT_GE(each.ticks, 25);
        EXPECT_LE(each.ticks, due);
    }
    EXPECT_EQ(pool->threads(), 2u);
}

TEST(TickLoop, never_runs_on_two_threads_at_once) {
    const auto pool = std::make_shared<TickPool>(4);
    CountingLoop counting;
    std::atomic<int> inside{0}, most{0};
    counting.start(pool, {.hz = 1000, .catch_up_ticks_max = 1000}, [&](const TickLoop::Tick&) {
        most = std::max(most.load(), ++inside);
        std::this_thread::sleep_for(300us);
        inside--;
        counting.loop.wake();
        return true;
    });
    ASSERT_TRUE(wait_until([&] { return counting.ticks > 100; }));
    counting.loop.stop();
    EXPECT_EQ(most, 1);
}

// 20 ticks of 10 ms each at once.
TEST(TickLoop, a_resting_world_runs_several_ticks_at_once) {
    const auto pool = std::make_shared<TickPool>(1);
    std::mutex mutex;
    std::vector<int> following;
    CountingLoop counting;
    counting.start(pool, {.hz = 100, .catch_up_ticks_max = 4, .rest_ticks = 20},
                   [&](const TickLoop::Tick& tick) {
                       const std::lock_guard lock(mutex);
                       following.push_back(tick.following);
                       EXPECT_EQ(tick.late_ticks, 0u);
                       return true;
                   });
    ASSERT_TRUE(wait_until([&] { return counting.ticks >= 21; }));
    counting.loop.stop();
    EXPECT_EQ(following[0], 0);
    EXPECT_GE(following[1], 19);
    for (std::size_t k = 2; k < 20; k++) EXPECT_EQ(following[k], following[k - 1] - 1);
}

// It rests for 10 s; its next tick is due 10 ms after the previous one.
TEST(TickLoop, wake_ends_the_rest_at_the_next_tick) {
    const auto pool = std::make_shared<TickPool>(1);
    CountingLoop counting;
    counting.start(pool, {.hz = 100, .catch_up_ticks_max = 4, .rest_ticks = 1000},
                   [](const TickLoop::Tick&) { return true; });
    ASSERT_TRUE(wait_until([&] { return counting.ticks == 1; }));
    std::this_thread::sleep_for(35ms);
    EXPECT_EQ(counting.ticks, 1);
    const auto woken = Clock::now();
    counting.loop.wake();
    ASSERT_TRUE(wait_until([&] { return counting.ticks >= 4; })) << "those that were due";
    EXPECT_LT(Clock::now() - woken, 1s);
}

TEST(TickLoop, a_call_of_wake_during_a_tick_is_not_lost) {
    const auto pool = std::make_shared<TickPool>(1);
    CountingLoop counting;
    counting.start(pool, {.hz = 100, .catch_up_ticks_max = 4, .rest_ticks = 1000},
                   [&](const TickLoop::Tick&) {
                       counting.loop.wake();
                       return true;
                   });
    EXPECT_TRUE(wait_until([&] { return counting.ticks >= 5; }));
    counting.loop.stop();
}

TEST(TickLoop, an_exception_ends_the_loop_and_is_reported) {
    const auto pool = std::make_shared<TickPool>(1);
    CountingLoop failing, other;
    failing.start(pool, hundred_hz,
                  [](const TickLoop::Tick&) -> bool { throw std::runtime_error("no memory"); });
    other.start(pool, hundred_hz, never_rests);
    ASSERT_TRUE(wait_until([&] { return other.ticks > 5; }));
    failing.loop.stop();
    EXPECT_EQ(failing.ticks, 1);
    EXPECT_EQ(failing.error, "no memory");
}

TEST(TickLoop, stop_waits_for_the_running_tick) {
    const auto pool = std::make_shared<TickPool>(2);
    CountingLoop counting;
    std::atomic<bool> ended{false};
    counting.start(pool, hundred_hz, [&](const TickLoop::Tick&) {
        std::this_thread::sleep_for(50ms);
        ended = true;
        return false;
    });
    ASSERT_TRUE(wait_until([&] { return counting.ticks > 0; }));
    counting.loop.stop();
    EXPECT_TRUE(ended);
    const int ticks = counting.ticks;
    std::this_thread::sleep_for(30ms);
    EXPECT_EQ(counting.ticks, ticks);
    counting.loop.wake();  // without effect
}

TEST(TickPool, adds_a_thread_for_a_loop_that_waits_behind_a_hung_tick) {
    const auto pool = std::make_shared<TickPool>(1);
    CountingLoop hung, other;
    std::atomic<bool> released{false};
    hung.start(pool, hundred_hz, [&](const TickLoop::Tick&) {
        while (!released) std::this_thread::sleep_for(1ms);
        return false;
    });
    ASSERT_TRUE(wait_until([&] { return hung.ticks > 0; }));
    other.start(pool, hundred_hz, never_rests);
    pool->add_thread_if_stuck(Clock::now());
    EXPECT_EQ(pool->threads(), 1u) << "the loop has not waited for long";
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(other.ticks, 0);
    pool->add_thread_if_stuck(Clock::now());
    EXPECT_EQ(pool->threads(), 2u);
    EXPECT_TRUE(wait_until([&] { return other.ticks > 5; }));
    pool->add_thread_if_stuck(Clock::now());
    EXPECT_EQ(pool->threads(), 2u);
    released = true;
}

}  // namespace
}  // namespace jostle::server
