// SPDX-License-Identifier: MIT
#include "server/world/between_ticks_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

class BetweenTicksExecutorTest : public testing::Test {
protected:
    // Ticks of the world's thread until `make` has returned.
    Status visit(const BetweenTicksExecutor::Task& look) {
        Status result;
        std::atomic<bool> over{false};
        std::thread asker([&] {
            result = visits.run(look);
            over = true;
        });
        while (!over) visits.run_pending(world);
        asker.join();
        return result;
    }

    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    BetweenTicksExecutor visits;
};

TEST_F(BetweenTicksExecutorTest, runs_task_on_the_world_thread_and_blocks_the_caller) {
    std::thread::id ran_on;
    int bodies = 0;
    EXPECT_TRUE(visit([&](HostedWorld& seen) {
                    ran_on = std::this_thread::get_id();
                    bodies = seen.world().summary().bodies;
                }).ok());
    EXPECT_EQ(ran_on, std::this_thread::get_id());
    EXPECT_GT(bodies, 5);
}

TEST_F(BetweenTicksExecutorTest, returns_an_error_when_the_task_cannot_run) {
    EXPECT_EQ(error_of(visit([](HostedWorld&) { throw std::bad_alloc(); })).code,
              ErrorCode::resource_exhausted);
    EXPECT_TRUE(visit([](HostedWorld&) {}).ok()) << "the next one is let in";
    std::thread waits(
        [&] { EXPECT_EQ(error_of(visits.run([](HostedWorld&) {})).code, ErrorCode::aborted); });
    // Until the other one stands in the door, this one waits there itself.
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(error_of(visits.run([](HostedWorld&) {})).code, ErrorCode::resource_exhausted);
    visits.close();
    waits.join();
    EXPECT_EQ(error_of(visits.run([](HostedWorld&) {})).code, ErrorCode::aborted);
}

}  // namespace
}  // namespace jostle::server
