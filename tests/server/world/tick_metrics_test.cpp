// SPDX-License-Identifier: MIT
//
// What is seen of ticks, and what seeing costs: under a hundredth of a tick. The figures are
// printed:
//   server_test --gtest_filter='*costs*'
#include "server/world/tick_metrics.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <ctime>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/metrics/metrics_text.h"
#include "server/world/hosted_world.h"
#include "server/world/world_host.h"
#include "tests/support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (int i = 0; i < physics::stage_count; i++)
        names.emplace_back(physics::stage_name(static_cast<physics::Stage>(i)));
    return names;
}

TEST(TickMetricsTest, profiles_ticks_of_a_running_world) {
    const auto host = *WorldHost::start("w1", "yard", *scenes::find_scene("sandbox"), {});
    const auto ticks = *host->tick_metrics().record(500ms);
    // 30 at 60 Hz; a busy machine may give some up.
    ASSERT_GE(ticks.size(), 5u);
    EXPECT_LE(ticks.size(), 40u);
    for (std::size_t i = 0; i < ticks.size(); i++) {
        const TickProfile& tick = ticks[i];
        EXPECT_TRUE(i == 0 || tick.tick == ticks[i - 1].tick + 1);
        EXPECT_LE(tick.begun, tick.step_begun);
        double step_ms = 0;
        for (const double ms : tick.stage_ms) step_ms += ms;
        EXPECT_GT(step_ms, 0);
        EXPECT_LE(step_ms, to_ms(tick.ended - tick.step_begun)) << "stages lie within the tick";
        EXPECT_GT(tick.bodies_awake, 0);
    }
}

TEST(TickMetricsTest, allows_one_profile_at_a_time_and_none_after_stop) {
    const auto host = *WorldHost::start("w1", "stack", *scenes::find_scene("stack"), {});
    std::thread other([&] { EXPECT_TRUE(host->tick_metrics().record(400ms).ok()); });
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(error_of(host->tick_metrics().record(1s)).code, ErrorCode::resource_exhausted);
    other.join();
    std::thread closes([&] {
        std::this_thread::sleep_for(100ms);
        host->stop();
    });
    const auto begun = Clock::now();
    EXPECT_TRUE(host->tick_metrics().record(30s).ok()) << "what there was until then";
    EXPECT_LT(Clock::now() - begun, 10s);
    closes.join();
    EXPECT_EQ(error_of(host->tick_metrics().record(1s)).code, ErrorCode::aborted);
}

TEST(TickMetricsTest, counts_ticks) {
    Metrics metrics("test", stage_names());
    WorldHostSettings settings;
    settings.metrics = &metrics;
    const auto host = *WorldHost::start("w1", "arena", *scenes::find_scene("stack"), settings);
    while (host->frame()->tick < 10) std::this_thread::sleep_for(5ms);
    const std::string text = metrics_text(metrics);
    const std::string bodies = std::to_string(host->frame()->entities.size());
    EXPECT_NE(text.find("jostle_world_bodies{world=\"arena\"} " + bodies + "\n"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("jostle_tick_duration_seconds_count{world=\"arena\"} 0"),
              std::string::npos);
    EXPECT_EQ(text.find("jostle_step_stage_seconds_total{stage=\"update_pairs\"} 0\n"),
              std::string::npos);
}

// --- cost ---

double thread_cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// What the thread of a host computes per tick, all of it: timer, step, frame and counting.
double cpu_per_tick(const char* name, Metrics* metrics) {
    scenes::SceneDescription scene = *scenes::find_scene(name);
    scene.hz = 500;
    std::atomic<int> ticks{0};
    double first = 0, last = 0;
    WorldHostSettings settings;
    settings.metrics = metrics;
    settings.on_frame = [&](bool) {
        last = thread_cpu_seconds();
        if (ticks++ == 0) first = last;
    };
    const auto host = *WorldHost::start("w1", name, scene, settings);
    while (ticks < 300) std::this_thread::sleep_for(5ms);
    host->stop();
    return (last - first) / (ticks - 1);
}

// The calls alone, with what the last step was like; also while somebody records.
struct Cost {
    double counting = 0, recording = 0;  // s a tick
};
Cost cost_of_watching(const char* name, Metrics& metrics) {
    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene(name), {}, 1));
    for (int i = 0; i < 30; i++) EXPECT_TRUE(world.step(1.0 / 60).ok());
    Frame frame;
    world.copy_into(frame);
    TickMetrics watch(&metrics, name);
    const auto seconds_of_a_tick = [&](int calls) {
        const double begun = thread_cpu_seconds();
        for (int i = 0; i < calls; i++) {
            watch.begin_tick(Clock::now());
            watch.begin_step();
            watch.end_tick(frame, &world.world().profile(), 3);
        }
        return (thread_cpu_seconds() - begun) / calls;
    };
    Cost cost{.counting = seconds_of_a_tick(20000)};
    std::thread other([&] { EXPECT_EQ(watch.record(20s)->size(), TickProfiler::ticks_max); });
    std::this_thread::sleep_for(50ms);
    cost.recording = seconds_of_a_tick(TickProfiler::ticks_max);
    other.join();
    return cost;
}

// Two runs differ by more than what is to be measured, so the calls alone are held to it.
TEST(TickMetricsTest, costs_less_than_one_percent_of_a_tick) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "times say nothing under the thread sanitizer";
#endif
    Metrics metrics("test", stage_names());
    for (const char* scene : {"stack", "sandbox", "pile"}) {
        const double without = cpu_per_tick(scene, nullptr), with = cpu_per_tick(scene, &metrics);
        const Cost cost = cost_of_watching(scene, metrics);
        std::printf(
            "%-8s a tick computes %7.2f us without, %7.2f us with; counting: %.3f us, %.2f %% of "
            "it; and recording: %.3f us\n",
            scene, 1e6 * without, 1e6 * with, 1e6 * cost.counting, 100 * cost.counting / without,
            1e6 * cost.recording);
        EXPECT_LT(cost.counting, 0.01 * without) << scene;
    }
}

}  // namespace
}  // namespace jostle::server
