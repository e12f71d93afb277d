// SPDX-License-Identifier: MIT
//
// The same test cases as clients/web/sdk/src/interpolation/rendered_time.test.ts.
#include "jostle/client/rendered_time.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

constexpr NewestFrame newest{600, 10'000'000};
constexpr double tick_length_us = 1e6 / 60;

double ticks(const v1::ViewTime& moment) {
    return moment.tick() + static_cast<double>(moment.fraction());
}

TEST(RenderedTime, is_behind_the_newest_frame_by_the_render_delay) {
    const v1::ViewTime shown = rendered_time(newest, 10'000'000 - 75'000, tick_length_us);
    EXPECT_EQ(shown.tick(), 595u);
    EXPECT_NEAR(shown.fraction(), 0.5, 1e-5);
}

TEST(RenderedTime, is_at_most_50_ms_after_the_newest_frame) {
    EXPECT_NEAR(ticks(rendered_time(newest, 10'400'000, tick_length_us)), 603, 1e-5);
}

TEST(RenderedTime, is_the_newest_frame_when_nothing_is_rendered) {
    EXPECT_EQ(ticks(rendered_time(newest, 0, tick_length_us)), 600);
    EXPECT_EQ(ticks(rendered_time(newest, 8'000'000, tick_length_us)), 600);
    EXPECT_EQ(rendered_time({}, 0, tick_length_us).tick(), 0u);
}

}  // namespace
}  // namespace jostle::client
