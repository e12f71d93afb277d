// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/speed/series_style.h"
#include "bench/speed/speed_plot.h"

namespace {

using namespace jostle::bench;
using testing::HasSubstr;
using testing::Not;

SpeedRow row(const char* engine, double ms, double error) {
    return {.scene = "a",
            .name = "pyramid",
            .engine = engine,
            .ms_mean = ms,
            .max_penetration_m = error};
}

TEST(SeriesStyle, is_the_same_in_every_plot) {
    EXPECT_EQ(series_style({"jostle", "bullet"}, 1).color,
              series_style({"jostle", "jostle, 2 threads", "bullet"}, 2).color);
    const std::vector<std::string> many = {"jostle, 4 threads", "bullet", "jostle, 8 threads"};
    EXPECT_STRNE(series_style(many, 0).color, series_style(many, 2).color);
}

TEST(Plot, labels_scenes_series_and_errors) {
    SpeedRow failed = row("ode", 0, 0);
    failed.failed = "ended by signal 11";
    SpeedRow two = row("jostle", 0.9, 0.0007);
    two.threads = 2;
    const std::string svg =
        plot_speed({row("jostle", 1.6, 0.0007), two, row("bullet", 3.1, 0.0101), failed}, "R & D");
    for (const char* words : {"<svg", "</svg>", "a pyramid", "jostle, 2 threads", "bullet",
                              "1.6 ms, 0.7 mm", "3.1 ms, 10 mm", "R &amp; D", "ms per step"})
        EXPECT_THAT(svg, HasSubstr(words));
    EXPECT_THAT(svg, Not(HasSubstr(">ode<")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Plot, growth_draws_one_curve_per_engine) {
    const std::string svg =
        plot_growth({{.engine = "jostle", .bodies = 500, .ms_mean = 1, .bytes_per_body = 2000},
                     {.engine = "jostle", .bodies = 5000, .ms_mean = 12, .bytes_per_body = 1800},
                     {.engine = "bullet", .bodies = 500, .ms_mean = 3, .bytes_per_body = 4000}},
                    "");
    for (const char* words : {"bytes per body", "10000", "jostle", "bullet", "<polyline"})
        EXPECT_THAT(svg, HasSubstr(words));
}

TEST(Plot, empty_plot_is_valid_svg) {
    EXPECT_THAT(plot_speed({}, ""), HasSubstr("</svg>"));
    EXPECT_THAT(plot_growth({}, ""), HasSubstr("</svg>"));
}

}  // namespace
