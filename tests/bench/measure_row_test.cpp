// SPDX-License-Identifier: MIT
//
// Rows of the speed table: their content, the conversion to JSON and back, and the row of a crash.
#include "bench/speed/speed_row.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include "bench/processes/program.h"
#include "bench/speed/speed_table.h"

namespace {

using namespace jostle::bench;

SpeedRow row_of(const char* engine, const char* scene, int steps, bool sleep = false) {
    return measure_row_in_child({.scene = find_speed_scene(scene),
                                 .engine = find_engine_kind(engine),
                                 .steps = steps,
                                 .sleep = sleep});
}

class Rows : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!find_engine_kind(GetParam())->make) GTEST_SKIP() << "not built in";
    }
};

TEST_P(Rows, pyramid_stays_standing_for_ten_steps) {
    const SpeedRow row = row_of(GetParam(), "a", 10);
    ASSERT_FALSE(row.failed) << *row.failed;
    EXPECT_EQ(row.scene + " " + row.name, "a bench_pyramid_465");
    EXPECT_EQ(row.engine, GetParam());
    EXPECT_EQ(row.bodies, 466);
    EXPECT_EQ(row.steps, 10);
    EXPECT_GT(row.ms_mean, 0);
    EXPECT_GE(row.ms_p99, row.ms_mean);
    EXPECT_GE(row.ms_worst, row.ms_moving_mean.value_or(0));
    EXPECT_GT(row.ms_first, 0);
    EXPECT_EQ(row.worst_stage.has_value(), row.engine == "jostle");
    EXPECT_TRUE(row.ms_moving_mean || row.ms_rest_mean);
    EXPECT_EQ(row.clock, "cpu");
    EXPECT_GT(*row.max_penetration_m, 0);
    EXPECT_LT(*row.max_penetration_m, 0.02);
    EXPECT_GE(*row.peak_penetration_m, *row.max_penetration_m);
    EXPECT_LE(*row.mean_penetration_m, *row.max_penetration_m);
    EXPECT_EQ(row.bodies_lost, 0);
    EXPECT_EQ(row.repeats, true);
    EXPECT_NEAR(row.top_m, 29.5, 0.15);
    EXPECT_GT(row.rss_mib, 1);
    EXPECT_FALSE(row.joint_drift_m || row.peak_joint_drift_m || row.asleep_at_step ||
                 row.tunnelled);
}

INSTANTIATE_TEST_SUITE_P(All, Rows, testing::Values("jostle", "bullet", "ode"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Rows, jostle_stops_all_bullets) {
    const SpeedRow row = row_of("jostle", "i", 20);
    EXPECT_EQ(row.tunnelled, 0);
    EXPECT_LT(*row.max_penetration_m, 0.01);
}

TEST(Rows, ragdoll_rows_report_joint_drift) {
    const SpeedRow row = row_of("jostle", "f", 10);
    ASSERT_TRUE(row.joint_drift_m && row.peak_joint_drift_m);
    EXPECT_LT(*row.peak_joint_drift_m, 0.01);
    EXPECT_EQ(row.error_m(), std::max(*row.joint_drift_m, *row.max_penetration_m));
}

TEST(Rows, reports_the_step_at_which_all_bodies_sleep) {
    const SpeedRow row = row_of("jostle", "a", 200, true);
    ASSERT_TRUE(row.asleep_at_step);
    EXPECT_GT(*row.asleep_at_step, 20);
}

// 900 cubes, some of which a player pushes; the others sleep.
TEST(Rows, reports_awake_bodies_at_the_end) {
    const SpeedRow row = row_of("jostle", "e", 120, true);
    ASSERT_TRUE(row.awake_at_end && row.moving_at_end);
    EXPECT_LE(*row.awake_at_end, 60);
    EXPECT_GE(*row.moving_at_end, 10);
    EXPECT_LE(*row.moving_at_end, *row.awake_at_end);
}

TEST(Rows, multithreaded_runs_use_wall_time_and_give_the_same_result) {
    const SpeedRow row = measure_row_in_child({.scene = find_speed_scene("a"),
                                               .engine = find_engine_kind("jostle"),
                                               .threads = 2,
                                               .steps = 5});
    EXPECT_EQ(row.clock, "wall");
    EXPECT_EQ(row.repeats, true);
}

TEST(Rows, errors_are_null_without_the_accuracy_check) {
    const SpeedRow row = measure_row_in_child({.scene = find_speed_scene("a"),
                                               .engine = find_engine_kind("jostle"),
                                               .steps = 5,
                                               .accuracy = false});
    EXPECT_FALSE(row.max_penetration_m || row.error_m() || row.repeats);
    EXPECT_NEAR(row.top_m, 29.5, 0.05);
}

TEST(Rows, parameters_change_the_scene_and_are_recorded) {
    ParameterValues eight;
    eight[static_cast<std::size_t>(Parameter::count)] = 8;
    const SpeedRow row = measure_row_in_child({.scene = find_speed_scene("hull_heap"),
                                               .engine = find_engine_kind("jostle"),
                                               .steps = 2,
                                               .parameters = eight});
    ASSERT_FALSE(row.failed) << *row.failed;
    EXPECT_EQ(row.bodies, 13);
    EXPECT_EQ(parameter_text(row.parameters), "count 8, vertices 64");
    EXPECT_TRUE(speed_line(row).ends_with("  count 8, vertices 64")) << speed_line(row);
}

TEST(Rows, round_trip_through_json) {
    SpeedRow row = row_of("jostle", "f", 2);
    EXPECT_EQ(to_json(speed_row_from(to_json(row))), to_json(row));
    EXPECT_TRUE(to_json(row).at("tunnelled").is_null());
    row.failed = "ended by signal 11";
    EXPECT_EQ(to_json(speed_row_from(to_json(row))), to_json(row));
    EXPECT_FALSE(to_json(row).contains("ms_mean"));
}

TEST(Rows, crashed_engine_gives_a_failed_row) {
    const EngineKind crashing{"crash", "", 1, []() -> std::unique_ptr<Engine> {
                                  std::raise(SIGKILL);
                                  return nullptr;
                              }};
    const SpeedRow row =
        measure_row_in_child({.scene = find_speed_scene("a"), .engine = &crashing, .steps = 1});
    EXPECT_EQ(row.failed, "ended by signal 9 (Killed)");
    EXPECT_NE(speed_line(row).find("failed: ended by signal 9 (Killed)"), std::string::npos);
}

TEST(ChildProcess, returns_output_of_any_length_or_the_failure) {
    EXPECT_EQ(run_in_child([] { return std::string(1 << 20, 'x'); }).text.size(), 1u << 20);
    const ChildResult thrown =
        run_in_child([]() -> std::string { throw std::runtime_error("no memory"); });
    EXPECT_EQ(thrown.failure, "no memory");
    EXPECT_EQ(thrown.text, "");
}

TEST(SpeedTable, heading_and_lines_have_the_same_columns) {
    const SpeedRow row = row_of("jostle", "a", 2);
    EXPECT_EQ(speed_heading().size(), speed_line(row).size());
    EXPECT_EQ(growth_heading().size(), growth_line({.engine = "jostle", .clock = "cpu"}).size());
    EXPECT_EQ(growth_fit_line({.engine = "jostle", .exponent = 1.0416}),
              "exponent of bodies             jostle    1    1.042");
}

}  // namespace
