// SPDX-License-Identifier: MIT
#include "bench/speed/server_row.h"

#include <gtest/gtest.h>

namespace jostle::bench {
namespace {

// In the format of jostlectl, in microseconds.
std::string tick(int duration, int begun_late, int late_ticks) {
    return R"({"ph":"X","name":"tick","ts":0,"dur":)" + std::to_string(duration) +
           R"(,"args":{"late_us":)" + std::to_string(begun_late) + R"(,"late_ticks":)" +
           std::to_string(late_ticks) + "}},";
}

std::string stage(const char* name) {
    return std::string(R"({"ph":"X","name":")") + name + R"(","ts":0,"dur":1},)";
}

std::string trace_of(const std::string& spans) {
    return R"({"traceEvents":[)" + spans + R"({"ph":"M","name":"thread_name"}]})";
}

TEST(TickTimes, start_at_the_first_step_and_include_sleeping_ticks) {
    const std::string paused = tick(90, 70, 5) + stage("inputs") + stage("frame_and_results");
    const std::string first = tick(4000, 100, 5) + stage("inputs") + stage("solve_constraints");
    const std::string late = tick(80000, 2500, 8) + stage("update_pairs");
    const std::string asleep = tick(50, 200, 9) + stage("inputs");
    const auto times = read_tick_times(trace_of(paused + first + late + asleep));
    ASSERT_TRUE(times.ok()) << times.error().message;
    EXPECT_EQ(times->ms, (std::vector<double>{4, 80, 0.05}));
    EXPECT_EQ(times->late, 4) << "9 in all, of which 5 were before the first step";
    EXPECT_EQ(times->begun_late_ms, 2.5);
}

TEST(TickTimes, world_without_steps_has_no_tick_times) {
    const auto times = read_tick_times(trace_of(tick(90, 70, 0) + stage("inputs")));
    ASSERT_TRUE(times.ok());
    EXPECT_TRUE(times->ms.empty());
}

TEST(TickTimes, rejects_invalid_traces) {
    for (const char* text : {"", "[]", R"({"traceEvents":[{"ph":"X","name":"tick"}]})"})
        EXPECT_FALSE(read_tick_times(text).ok()) << text;
}

TEST(ServerRow, verdict_is_holds_only_if_every_tick_fits_its_period) {
    EXPECT_STREQ(verdict_of({.ticks = 600}), "holds");
    EXPECT_STREQ(verdict_of({.ticks = 600, .ticks_over_period = 1}), "catches up");
    EXPECT_STREQ(verdict_of({.ticks = 599, .late_ticks = 1, .ticks_over_period = 1}), "late");
}

TEST(ServerRow, failed_row_has_no_results) {
    const auto json = to_json(ServerRow{.scene = "c", .failed = "no server"});
    EXPECT_EQ(json["failed"], "no server");
    EXPECT_FALSE(json.contains("ms_mean"));
}

}  // namespace
}  // namespace jostle::bench
