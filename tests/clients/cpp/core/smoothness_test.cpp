// SPDX-License-Identifier: MIT
//
// One minute of a known world over simulated networks, rendered 144 and 60 times per second.
// clients/web/sdk/src/interpolation/smoothness.test.ts has the same test cases.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/clients/cpp/core/observed_world.h"

namespace jostle::client {
namespace {

struct Link {
    const char* name;
    NetworkConditions link;
    // Allowed errors; measured values are slightly lower.
    double usual_error_mm, error_mm, behind_ms;
};

void PrintTo(const Link& told, std::ostream* out) {
    *out << told.name;
}

// The errors are those of extrapolation: interpolation cuts a bounce by 23 mm, and a body at 3 m/s
// is 2.6 m off at the end of a stall of 1 s.
const Link bad_links[] = {
    {"even", {.latency_ms = 40}, 2, 25, 75},
    {"uniform_20", {.latency_ms = 40, .jitter_ms = 20}, 2, 25, 82},
    {"uniform_80", {.latency_ms = 40, .jitter_ms = 80}, 3, 50, 140},
    {"exponential_15", {.latency_ms = 40, .jitter_tail_ms = 15}, 10, 125, 112},
    {"stalls_250_ms",
     {.latency_ms = 40, .jitter_ms = 10, .stall_ms = 250, .stall_interval_ms = 5000},
     250,
     540,
     112},
    {"stalls_1_s",
     {.latency_ms = 40, .jitter_ms = 10, .stall_ms = 1000, .stall_interval_ms = 10'000},
     2050,
     2620,
     75},
    {"loss_2_percent", {.latency_ms = 40, .jitter_ms = 5, .loss = 0.02}, 35, 360, 220},
};

class Smoothness : public testing::TestWithParam<Link> {};

}  // namespace

TEST_P(Smoothness, render_clock_is_monotonic_and_bodies_move_smoothly) {
    for (const double pictures_hz : {144.0, 60.0}) {
        const Observation seen = observe(GetParam().link, pictures_hz);
        SCOPED_TRACE(std::to_string(pictures_hz) + " rendered frames per second");
        const auto record = [&](const char* name, double value) {
            RecordProperty(name + std::to_string(static_cast<int>(pictures_hz)),
                           std::to_string(value));
        };
        record("step_mm_", seen.step_mm);
        record("usual_error_mm_", seen.usual_error_mm);
        record("error_mm_", seen.error_mm);
        record("behind_ms_", seen.behind_ms);
        record("least_speed_", seen.least_speed);
        record("greatest_speed_", seen.greatest_speed);

        EXPECT_GT(seen.pictures, 58 * pictures_hz);
        EXPECT_EQ(seen.backward_steps, 0);
        EXPECT_GT(seen.least_speed, 0.9);
        EXPECT_LT(seen.greatest_speed, 1.1);
        EXPECT_LT(seen.step_mm, 20);
        EXPECT_EQ(seen.halfway_leaps, 0) << "a teleported body is never rendered in between";
        EXPECT_EQ(seen.ghosts, 0) << "a removed body is not rendered";
        EXPECT_LT(seen.usual_error_mm, GetParam().usual_error_mm);
        EXPECT_LT(seen.error_mm, GetParam().error_mm);
        EXPECT_LT(seen.behind_ms, GetParam().behind_ms);
    }
}

INSTANTIATE_TEST_SUITE_P(Links, Smoothness, testing::ValuesIn(bad_links),
                         [](const auto& told) { return told.param.name; });

}  // namespace jostle::client
