// SPDX-License-Identifier: MIT
#include "host/tick_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

// A world's thread that counts what it steps.
class Ticking {
public:
    explicit Ticking(TickGate& gate)
        : thread_([this, &gate] {
              while (!done_) {
                  if (gate.begin_tick()) steps_++;
                  ticks_++;
                  gate.end_tick();
                  std::this_thread::sleep_for(100us);
              }
          }) {}
    ~Ticking() {
        done_ = true;
        thread_.join();
    }
    int steps() const { return steps_; }
    void wait_for_ticks(int count) const {
        for (const int end = ticks_ + count; ticks_ < end;) std::this_thread::sleep_for(100us);
    }

private:
    std::atomic<int> steps_{0}, ticks_{0};
    std::atomic<bool> done_{false};
    std::thread thread_;
};

TEST(TickGateTest, a_paused_world_takes_the_steps_that_are_allowed_and_no_more) {
    TickGate gate;
    const Ticking world(gate);
    world.wait_for_ticks(5);
    EXPECT_GE(world.steps(), 5);
    gate.set_paused(true);
    world.wait_for_ticks(2);
    const int before = world.steps();
    world.wait_for_ticks(20);
    EXPECT_EQ(world.steps(), before);
    EXPECT_EQ(*gate.take_steps(7, 20s), 0);
    EXPECT_EQ(world.steps(), before + 7);
    world.wait_for_ticks(20);
    EXPECT_EQ(world.steps(), before + 7);
    gate.set_paused(false);
    world.wait_for_ticks(5);
    EXPECT_GE(world.steps(), before + 11);
}

TEST(TickGateTest, says_why_it_does_not_step) {
    TickGate gate;
    EXPECT_EQ(error_of(gate.take_steps(1, 1s)).code, ErrorCode::failed_precondition);
    gate.set_paused(true);
    // Nobody ticks: the steps are still to be taken when patience ends, and are forgotten then.
    EXPECT_EQ(*gate.take_steps(3, 10ms), 3);
    EXPECT_FALSE(gate.begin_tick());
    std::thread other([&] { EXPECT_EQ(*gate.take_steps(4, 20s), 4); });
    while (!gate.begin_tick()) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(error_of(gate.take_steps(1, 1s)).code, ErrorCode::resource_exhausted);
    gate.close();
    other.join();
    EXPECT_EQ(error_of(gate.take_steps(1, 1s)).code, ErrorCode::aborted);
}

}  // namespace
}  // namespace jostle::server
