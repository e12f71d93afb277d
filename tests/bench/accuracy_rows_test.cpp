// SPDX-License-Identifier: MIT
//
// Rows of the accuracy benchmark: a Jostle row of each family, and equal scenes for all engines.
#include <gtest/gtest.h>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/run_row.h"
#include "bench/accuracy/stress_test.h"

namespace {

using namespace jostle::bench::accuracy;

Row row_of(const char* scene, const char* engine, double rate_hz, const char* mode = nullptr) {
    const EngineKind& kind = *find_engine_kind(engine);
    return run_row(*find_experiment(scene), kind, mode ? mode : kind.modes[0], rate_hz);
}

struct Expected {
    const char* scene;
    double rate_hz, most_error;
};

class JostleRows : public testing::TestWithParam<Expected> {};

TEST_P(JostleRows, stay_within_their_error_limits) {
    const auto [scene, rate_hz, most_error] = GetParam();
    const Row row = row_of(scene, "jostle", rate_hz);
    ASSERT_TRUE(row.usable()) << row.failed << row.unsupported;
    EXPECT_LT(row.error, most_error);
    EXPECT_GT(row.cpu_us_per_second, 0);
}

// Twice the errors of the solver when the benchmark was written.
INSTANTIATE_TEST_SUITE_P(Families, JostleRows,
                         testing::Values(Expected{"f1", 60, 1e-12}, Expected{"f3", 60, 0.05},
                                         Expected{"f4", 60, 1e-11}, Expected{"f6", 60, 0.2},
                                         Expected{"j1", 60, 0.003}, Expected{"j3-r1", 60, 0.02},
                                         Expected{"j4", 60, 0.004}, Expected{"j5", 60, 0.025},
                                         Expected{"c1", 60, 0.001}, Expected{"c5-e0.8", 60, 0.008},
                                         Expected{"c6", 60, 0.1}, Expected{"c8", 60, 0.002},
                                         Expected{"c11", 60, 0.005}, Expected{"c15", 60, 0.5}),
                         [](const auto& test) {
                             std::string name = test.param.scene;
                             for (char& c : name)
                                 if (c == '-' || c == '.') c = '_';
                             return name;
                         });

class Engines : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!find_engine_kind(GetParam())->make) GTEST_SKIP() << "not built in";
    }
};

// Symplectic Euler is of first order, with an error of 0.17 m for a fall of 2 s at 60 Hz; all other
// methods are more accurate.
TEST_P(Engines, swing_a_pendulum_and_converge) {
    const Row slow = row_of("j1-5", GetParam(), 60), fast = row_of("j1-5", GetParam(), 240);
    ASSERT_TRUE(slow.usable() && fast.usable()) << slow.failed << slow.unsupported;
    EXPECT_LT(slow.error, 0.002);
    EXPECT_LT(fast.error, 0.6 * slow.error);
}

TEST_P(Engines, close_a_loop) {
    const Row row = row_of("j4", GetParam(), 240);
    ASSERT_TRUE(row.usable()) << row.failed << row.unsupported;
    EXPECT_LT(row.error, 0.03);
    EXPECT_LT(row.second_error, 0.001);
}

TEST_P(Engines, hold_a_stack_of_ten) {
    const Row row = row_of("c8", GetParam(), 240);
    ASSERT_TRUE(row.usable()) << row.failed << row.unsupported;
    EXPECT_LT(row.error, 0.2);
}

TEST_P(Engines, every_mode_builds) {
    for (const std::string& mode : find_engine_kind(GetParam())->modes) {
        const Row row = row_of("j2", GetParam(), 120, mode.c_str());
        EXPECT_TRUE(row.usable()) << mode << ": " << row.failed << row.unsupported;
        EXPECT_LT(row.error, 0.1) << mode;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Engines,
                         testing::Values("jostle", "bullet", "ode", "mujoco", "box2d"),
                         [](const auto& test) { return std::string(test.param); });

// A motor turns a rod against a limit, because the signs of angles and speeds differ between
// engines.
TEST_P(Engines, rotate_in_the_expected_direction) {
    const Row row = row_of("j6", GetParam(), 480);
    if (!row.unsupported.empty()) GTEST_SKIP() << row.unsupported;
    EXPECT_LT(row.error, 0.8) << "a delay of one sample at the limit is an error of 0.77";
    EXPECT_LT(row.second_error, 0.05);
}

// Joint coordinates have no gaps, and RK4 in them is of fourth order. The pendulum's error is below
// 1e-5 at 30 Hz.
TEST(BulletTrees, keep_joints_closed_and_converge_at_runge_kutta_order) {
    if (!find_engine_kind("bullet")->make) GTEST_SKIP() << "not built in";
    const Row slow = row_of("j1", "bullet", 30, "mb-rk4"),
              fast = row_of("j1", "bullet", 60, "mb-rk4");
    ASSERT_TRUE(slow.usable() && fast.usable()) << slow.failed << slow.unsupported;
    EXPECT_LT(slow.error, 1e-5);
    EXPECT_LT(fast.error, slow.error / 10);
    for (const char* scene : {"f6", "j1", "j2", "j3-r1", "j9"})
        EXPECT_LT(row_of(scene, "bullet", 120, "mb").second_error, 1e-9) << scene;
    EXPECT_LT(row_of("j4", "bullet", 240, "mb").second_error, 1e-6);  // a loop
    EXPECT_LT(row_of("j5", "bullet", 240, "mb").error, 0.01);         // a motor and a slider
    EXPECT_LT(row_of("j7", "bullet", 120, "mb").error, 0.05);         // damped to rest
    EXPECT_EQ(row_of("c8", "bullet", 60, "mb").unsupported, "bullet's trees support no contacts");
    EXPECT_EQ(row_of("f2-1", "bullet", 60, "mb").unsupported,
              "bullet's trees support jointed bodies only");
}

TEST(Rows, report_unsupported_features) {
    if (!find_engine_kind("box2d")->make) GTEST_SKIP() << "not built in";
    const Row row = row_of("f1", "box2d", 60);
    EXPECT_EQ(row.unsupported, "box2d supports planar scenes only");
    EXPECT_FALSE(row.usable());
}

TEST(Experiments, have_unique_names_and_decreasing_tolerances) {
    for (const Experiment& experiment : all_experiments()) {
        EXPECT_EQ(find_experiment(experiment.name), &experiment);
        for (std::size_t k = 1; k < experiment.tolerances.size(); k++)
            EXPECT_LT(experiment.tolerances[k], experiment.tolerances[k - 1]) << experiment.name;
        EXPECT_FALSE(experiment.tolerances.empty()) << experiment.name;
    }
    EXPECT_EQ(find_experiment("j99"), nullptr);
}

Verdict verdict_of(const char* id) {
    const EngineKind& jostle = *find_engine_kind("jostle");
    for (const StressTest& test : all_stress_tests())
        if (test.id == id) return test.run(jostle, jostle.modes[0]);
    ADD_FAILURE() << "no test " << id;
    return {};
}

TEST(Stress, stack_stands_and_invalid_inputs_are_rejected) {
    EXPECT_TRUE(verdict_of("s1").pass);
    EXPECT_TRUE(verdict_of("s16").pass);
    const Verdict inputs = verdict_of("s22");
    EXPECT_TRUE(inputs.pass) << inputs.figure.value_or(-1) << " harmful inputs were accepted";
}

TEST(Stress, result_above_the_limit_fails) {
    const StressRun run{
        .start = [] { return find_experiment("f1")->start(0); }, .speed_bound = 1, .limit = 1};
    const EngineKind& jostle = *find_engine_kind("jostle");
    const Verdict too_fast = run_stress(run, jostle, "sub8");
    EXPECT_FALSE(too_fast.pass);
    EXPECT_NE(too_fast.why.find("m/s"), std::string::npos);
    StressRun strict = run;
    strict.speed_bound = 0;
    strict.limit = 1e-20;
    EXPECT_FALSE(run_stress(strict, jostle, "sub8").pass);
}

}  // namespace
