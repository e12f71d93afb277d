// SPDX-License-Identifier: MIT
//
// Worlds that hang and worlds that fail, and what is done about them.
#include "server/world/tick_watchdog.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/metrics/metrics_text.h"
#include "server/world/command_mailbox.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::wait_until;

// The thread sanitizer makes everything slower.
#ifdef __SANITIZE_THREAD__
constexpr int pile_size = 60;
#else
constexpr int pile_size = 200;
#endif

// A pile whose step takes a while: boxes in one place, as no budget would let in.
scenes::SceneDescription heavy() {
    scenes::SceneDescription scene{.name = "heavy"};
    scene.world.substeps = 64;
    scene.world.sleeping = false;
    for (int i = 0; i < pile_size; i++) {
        scenes::SceneBody body;
        body.body.pose.position = {i * 1e-4, 0, 0};
        body.shapes.push_back({.geometry = physics::Box{}});
        scene.bodies.push_back(body);
    }
    return scene;
}

TEST(TickWatchdog, interrupts_a_slow_step_and_pauses_the_world) {
    WorldDirectory worlds({.limits = {.scene = {.work_per_second_max = 1e12,
                                                .pairs_per_shape_max = 0,
                                                .first_step_seconds_max = 600}}},
                          2);
    const auto slow = *worlds.create("", heavy());
    const auto other = *worlds.create("", *scenes::find_scene("stack"));
    const TickWatchdog watch(worlds, {.tick_cpu_max = 100ms});
    ASSERT_TRUE(wait_until([&] { return slow->lifecycle().paused().has_value(); }));
    const std::string reason = slow->lifecycle().paused().value_or("");
    EXPECT_TRUE(reason.starts_with("a tick used 0.")) << reason;
    EXPECT_TRUE(reason.ends_with("; the world resumes after 1 s")) << reason;
    // It ticks on, without steps, and the other world is unaffected.
    const std::uint32_t tick = slow->frame()->tick;
    EXPECT_TRUE(wait_until([&] { return slow->frame()->tick > tick + 5; }));
    EXPECT_EQ(slow->frame()->time_scale, 0);
    EXPECT_FALSE(other->lifecycle().paused());
    const auto began = Clock::now();
    slow->stop();
    EXPECT_LT(Clock::now() - began, 2s);
}

// The same step again: each pause is twice as long as the previous one.
TEST(TickWatchdog, an_overloaded_world_resumes_by_itself_and_pauses_for_longer) {
    WorldDirectory worlds({.limits = {.scene = {.work_per_second_max = 1e12,
                                                .pairs_per_shape_max = 0,
                                                .first_step_seconds_max = 600}}},
                          1);
    const auto slow = *worlds.create("", heavy());
    const TickWatchdog watch(worlds, {.tick_cpu_max = 100ms});
    const auto paused_for = [&](const std::string& time) {
        return wait_until([&] {
            return slow->lifecycle().paused().value_or("").ends_with("resumes after " + time);
        });
    };
    EXPECT_TRUE(paused_for("1 s"));
    EXPECT_TRUE(paused_for("2 s"));
    EXPECT_TRUE(slow->lifecycle().resumes_by_itself());
    slow->pause("by an operator");
    EXPECT_FALSE(slow->lifecycle().resumes_by_itself());
}

// A busy or stopped machine delays a tick; the tick itself does nothing wrong.
TEST(TickWatchdog, a_tick_that_waits_is_not_interrupted) {
    std::atomic<int> frames{0};
    WorldDirectory worlds({.on_frame =
                               [&](bool) {
                                   if (++frames == 20) std::this_thread::sleep_for(500ms);
                               }},
                          1);
    const auto world = *worlds.create("", *scenes::find_scene("stack"));
    const TickWatchdog watch(worlds, {.tick_cpu_max = 100ms});
    ASSERT_TRUE(wait_until([&] { return frames > 30; }));
    EXPECT_FALSE(world->lifecycle().paused());
}

TEST(TickWatchdog, stops_a_world_during_a_long_step) {
    const auto slow = *WorldHost::start("w1", "slow", heavy(),
                                        {.limits = {.scene = {.work_per_second_max = 1e12,
                                                              .pairs_per_shape_max = 0,
                                                              .first_step_seconds_max = 600}}});
    ASSERT_TRUE(
        wait_until([&] { return slow->lifecycle().running_tick(Clock::now()).has_value(); }));
    std::this_thread::sleep_for(100ms);
    const auto began = Clock::now();
    slow->stop();
    EXPECT_LT(Clock::now() - began, 3s) << "whatever the step alone would take";
}

TEST(TickWatchdog, a_hung_world_does_not_make_the_process_unhealthy) {
    Metrics metrics("test", {});
    std::atomic<int> frames{0};
    WorldDirectory worlds({.on_frame =
                               [&](bool) {
                                   if (++frames == 20) std::this_thread::sleep_for(1500ms);
                               },
                           .metrics = &metrics},
                          1);
    ASSERT_TRUE(worlds.create("arena", *scenes::find_scene("stack")).ok());
    const TickWatchdog watch(worlds, {.hung_after = 500ms});
    const auto hung = [&](const char* value) {
        const std::string line = std::string("jostle_world_hung{world=\"arena\"} ") + value;
        return metrics_text(metrics).find(line) != std::string::npos;
    };
    EXPECT_TRUE(wait_until([&] { return hung("1"); }));
    EXPECT_TRUE(watch.is_alive(Clock::now()));
    EXPECT_TRUE(wait_until([&] { return hung("0"); }));
}

TEST(TickWatchdog, is_not_alive_while_its_thread_does_not_run) {
    WorldDirectory worlds({}, 1);
    const TickWatchdog watch(worlds, {});
    EXPECT_TRUE(watch.is_alive(Clock::now()));
    EXPECT_FALSE(watch.is_alive(Clock::now() + 6s));
}

TEST(TickWatchdog, restarts_a_failed_world_and_gives_up_after_repeated_failures) {
    std::atomic<int> failures{0};
    WorldHostSettings settings;
    settings.on_frame = [&](bool) {
        failures++;
        throw std::runtime_error("no memory");
    };
    WorldDirectory worlds(settings, 2, "aa");
    const auto first = *worlds.create("arena", *scenes::find_scene("stack"));
    EXPECT_EQ(first->id(), "w1-aa");
    ASSERT_TRUE(wait_until([&] { return first->lifecycle().failed(); }));
    worlds.restart_failed(Clock::now());
    const auto second = worlds.find("arena");
    ASSERT_TRUE(second);
    EXPECT_NE(second, first);
    EXPECT_EQ(second->id(), "w1-aa");
    for (int i = 0; i < 3; i++) {
        const auto present = worlds.find("arena");
        ASSERT_TRUE(!present || wait_until([&] { return present->lifecycle().failed(); }));
        worlds.restart_failed(Clock::now());
    }
    EXPECT_FALSE(worlds.find("arena")) << "after three times in a minute";
    EXPECT_EQ(failures, 4);
}

TEST(WorldHost, paused_world_sends_snapshots_and_rejects_inputs) {
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), {});
    host->pause("for a look");
    ASSERT_TRUE(wait_until([&] { return host->frame()->paused.has_value(); }));
    const auto before = host->frame();
    const auto replies = std::make_shared<ResultQueue>();
    ASSERT_TRUE(host->mailbox().push(
        {.client = 1, .sequence = 1, .action = ExplodeCommand{}, .reply = replies}));
    std::vector<InputResult> results;
    ASSERT_TRUE(wait_until([&] {
        for (InputResult& result : replies->take()) results.push_back(std::move(result));
        return !results.empty();
    }));
    EXPECT_EQ(results[0].status.error().message, "the world is paused: for a look");
    EXPECT_GT(host->frame()->tick, before->tick);
    host->resume();
    EXPECT_TRUE(wait_until([&] { return !host->frame()->paused; }));
}

}  // namespace
}  // namespace jostle::server
