// SPDX-License-Identifier: MIT
#include "server/world/single_step_control.h"

#include <gtest/gtest.h>

#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/world/command_mailbox.h"
#include "server/world/world_host.h"
#include "tests/support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

// How far the ball has fallen says how many steps were taken.
TEST(SingleStepControlTest, paused_world_takes_only_requested_steps) {
    scenes::SceneDescription scene;
    scene.name = "falling";
    scene.bodies.push_back(
        {.name = "ball", .body = {}, .shapes = {{.geometry = physics::Sphere{}}}});
    const auto host = *WorldHost::start("w1", "falling", scene, {});
    const auto height = [&] { return host->frame()->entities[0].pose.position.y; };
    const auto wait_for_ticks = [&](std::uint32_t count) {
        for (const std::uint32_t end = host->frame()->tick + count; host->frame()->tick < end;)
            std::this_thread::sleep_for(1ms);
    };
    host->pause("looking at it");
    wait_for_ticks(2);  // the one that ran may have begun before
    const double before = height();
    wait_for_ticks(10);
    EXPECT_EQ(height(), before) << "it ticks, and no time passes";
    EXPECT_EQ(*host->single_step().step(7, 20s), 7);
    const double after = height();
    EXPECT_LT(after, before - 7 * 6 / 2 * 9.81 / 3600) << "seven steps from rest fall so far";
    wait_for_ticks(10);
    EXPECT_EQ(height(), after);
    host->resume();
    wait_for_ticks(5);
    EXPECT_LT(height(), after);
}

TEST(SingleStepControlTest, paused_world_rejects_inputs) {
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), {});
    host->pause("maintenance");
    const auto replies = std::make_shared<ResultQueue>();
    SpawnCommand spawn;
    spawn.shape.geometry = physics::Sphere{0.1};
    const std::uint32_t tick = host->frame()->tick;
    while (host->frame()->tick < tick + 2) std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(
        host->mailbox().push({.client = 1, .sequence = 1, .action = spawn, .reply = replies}));
    std::vector<InputResult> results;
    while (results.empty()) {
        results = replies->take();
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(error_of(results[0].status).code, ErrorCode::resource_exhausted);
    EXPECT_NE(error_of(results[0].status).message.find("maintenance"), std::string::npos);
    EXPECT_EQ(host->lifecycle().paused(), "maintenance");
}

TEST(SingleStepControlTest, returns_the_reason_when_it_cannot_step) {
    SingleStepControl steps;
    // Nobody ticks: patience ends, and what was allowed is so no more.
    EXPECT_EQ(*steps.step(3, 10ms), 0);
    EXPECT_FALSE(steps.begin_step());
    std::thread other([&] { EXPECT_EQ(*steps.step(4, 20s), 1); });
    while (!steps.begin_step()) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(error_of(steps.step(1, 1s)).code, ErrorCode::resource_exhausted);
    steps.end_tick();
    steps.close();
    other.join();
    EXPECT_EQ(error_of(steps.step(1, 1s)).code, ErrorCode::aborted);
}

}  // namespace
}  // namespace jostle::server
