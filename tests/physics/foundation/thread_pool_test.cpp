// SPDX-License-Identifier: MIT
#include "physics/src/foundation/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace jostle::test {
namespace {
using physics::ThreadPool;

TEST(ThreadPool, range_is_covered_once) {
    for (const int threads : {1, 2, 5}) {
        ThreadPool thread_pool(threads);
        for (int round = 0; round < 200; round++) {
            std::vector<int> seen(1000 + static_cast<std::size_t>(round), 0);
            thread_pool.run(
                static_cast<int>(seen.size()), 7,
                [&](int begin, int end) {
                    for (int k = begin; k < end; k++) seen[static_cast<std::size_t>(k)]++;
                },
                round % 2 == 0 ? ThreadPool::Split::free : ThreadPool::Split::fixed);
            for (const int times : seen) ASSERT_EQ(times, 1);
        }
    }
}

TEST(ThreadPool, each_task_runs_once) {
    for (const int threads : {1, 2, 5}) {
        ThreadPool thread_pool(threads);
        for (int round = 0; round < 500; round++) {
            std::vector<int> seen(static_cast<std::size_t>(round % 9), 0);
            if (round % 3 == 0) thread_pool.wake();
            thread_pool.run_tasks(round % 9, [&](int k) { seen[static_cast<std::size_t>(k)]++; });
            for (const int times : seen) ASSERT_EQ(times, 1);
        }
    }
}

// Whoever takes it, the job is done once, and before finish() returns; ranges go on beside it.
TEST(ThreadPool, background_job_runs_once_during_ranges) {
    for (const int threads : {1, 2, 5}) {
        ThreadPool thread_pool(threads);
        for (int round = 0; round < 2000; round++) {
            int done = 0;
            std::atomic<int> sum{0};
            thread_pool.start([&] { done++; });
            for (int part = 0; part < round % 4; part++)
                thread_pool.run(64, 1, [&](int begin, int end) { sum += end - begin; });
            thread_pool.finish();
            ASSERT_EQ(done, 1) << threads << " threads, round " << round;
            ASSERT_EQ(sum, 64 * (round % 4));
        }
        thread_pool.finish();  // of nothing
    }
}

// Who works on its own part and loses its processor is helped all the same: of 40 grains the worker
// does the one in which it sleeps and not all twenty of its part.
TEST(ThreadPool, other_threads_take_over_the_range_of_a_stalled_thread) {
    ThreadPool thread_pool(2);
    const auto caller = std::this_thread::get_id();
    std::atomic<int> done = 0, by_worker = 0;
    for (int round = 0; round < 50 && by_worker == 0; round++) {
        done = 0;
        thread_pool.wake();
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        thread_pool.run(
            40, 1,
            [&](int begin, int end) {
                done += end - begin;
                if (std::this_thread::get_id() == caller) {
                    std::this_thread::sleep_for(std::chrono::microseconds(100));
                } else {
                    by_worker++;
                    std::this_thread::sleep_for(std::chrono::milliseconds(100));
                }
            },
            ThreadPool::Split::fixed);
        ASSERT_EQ(done, 40);
    }
    EXPECT_GE(by_worker, 1);
    EXPECT_LE(by_worker, 2);
}

// A worker that is woken for a range may come when the team is already being let go: it must see
// that, and not go back to sleep for good.
TEST(ThreadPool, destructor_is_safe_while_workers_wake) {
    std::atomic<int> done = 0;
    for (int round = 0; round < 1500; round++) {
        ThreadPool thread_pool(4);
        std::this_thread::sleep_for(std::chrono::microseconds(100 + round % 400));
        thread_pool.run(8, 1, [&](int begin, int end) { done += end - begin; });
    }
    EXPECT_EQ(done, 1500 * 8);
}

}  // namespace
}  // namespace jostle::test
