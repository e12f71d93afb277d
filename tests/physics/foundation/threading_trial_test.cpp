// SPDX-License-Identifier: MIT
#include "physics/src/foundation/threading_trial.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using physics::ThreadingTrial;

// How many of so many steps are shared, if they take so long alone and shared.
int shared_steps(ThreadingTrial& trial, int steps, double alone_ms, double shared_ms) {
    int shared = 0;
    bool last = false;
    for (int k = 0; k < steps; k++) {
        last = trial.shares(last ? shared_ms : alone_ms);
        shared += last ? 1 : 0;
    }
    return shared;
}

// Ten seconds at 60 Hz, in which it is tried three times for four steps: the first, and three that
// are no better.
TEST(ThreadingTrial, keeps_one_thread_if_two_are_slower) {
    ThreadingTrial trial;
    EXPECT_LE(shared_steps(trial, 600, 0.30, 0.40), 12);
}

TEST(ThreadingTrial, uses_two_threads_if_they_are_faster) {
    ThreadingTrial trial;
    EXPECT_GE(shared_steps(trial, 600, 0.40, 0.30), 600 - 8 - 12);
}

// A step of 5 ms alone would be a late one.
TEST(ThreadingTrial, long_steps_are_always_multithreaded) {
    ThreadingTrial trial;
    shared_steps(trial, 3, 5.0, 3.0);
    EXPECT_EQ(shared_steps(trial, 600, 5.0, 3.0), 600);
}

TEST(ThreadingTrial, growing_steps_are_multithreaded_within_three_steps) {
    ThreadingTrial trial;
    for (int k = 0; k < 4; k++) trial.shares(0.3);
    EXPECT_FALSE(trial.shares(2.4));
    EXPECT_FALSE(trial.shares(2.4));
    EXPECT_TRUE(trial.shares(2.4));
    EXPECT_EQ(shared_steps(trial, 100, 3.6, 2.4), 100);
}

// A scene that changes is tried again: the longest pause is 512 steps.
TEST(ThreadingTrial, switches_to_two_threads_within_nine_seconds_once_faster) {
    ThreadingTrial trial;
    shared_steps(trial, 600, 0.30, 0.40);
    EXPECT_GE(shared_steps(trial, 540 + 100, 0.90, 0.60), 100 - 18);
}

// One step in ten is disturbed, for longer than a long step takes.
TEST(ThreadingTrial, ignores_a_single_disturbed_step) {
    ThreadingTrial trial;
    int shared = 0;
    bool last = false;
    for (int k = 0; k < 600; k++) {
        last = trial.shares((last ? 0.3 : 0.4) + (k % 10 == 0 ? 2 : 0));
        shared += last ? 1 : 0;
    }
    EXPECT_GE(shared, 600 - 8 - 12);
}

}  // namespace
}  // namespace jostle::test
