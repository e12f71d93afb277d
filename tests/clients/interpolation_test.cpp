// SPDX-License-Identifier: MIT
#include "jostle/client/interpolation.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

wire::QuantizedFrame body_at(std::uint32_t frame, double x) {
    return {.frame = frame, .entities = {wire::quantize(1, {{x, 0, 0}, {0, 0, 0, 1}}, false, {})}};
}

}  // namespace

TEST(Interpolation, shows_even_motion_evenly_although_frames_arrive_in_bursts) {
    InterpolationBuffer buffer;
    // One metre a second at 60 Hz; every fourth frame is 30 ms late.
    std::int64_t drawn_at = 0;
    double last = -1, worst = 0;
    for (int i = 0; i < 600; i++) {
        const std::int64_t due = 1'000'000 + i * 16'667;
        const std::int64_t arrived = due + 2'000 + (i % 4 == 0 ? 30'000 : 0);
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i / 60.0), due, arrived);
        if (i < 200) continue;  // until the delay has settled
        drawn_at = due + 2'000;
        const auto poses = buffer.sample(drawn_at, {});
        ASSERT_EQ(poses.size(), 1u);
        const double x = poses[0].pose.position[0];
        if (last >= 0) worst = std::max(worst, std::abs(x - last - 1.0 / 60));
        last = x;
    }
    EXPECT_LT(worst, 0.006);  // m; two units of the quantiser and what is left of adapting
    EXPECT_GT(buffer.delay_ms(), 40);
    EXPECT_LT(buffer.delay_ms(), 60);
}

TEST(Interpolation, goes_on_for_fifty_milliseconds_when_frames_stop_then_holds) {
    InterpolationBuffer buffer;
    for (int i = 0; i < 60; i++)
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i), i * 16'667, i * 16'667);
    const double soon = buffer.sample(59 * 16'667 + 1'000'000, {})[0].pose.position[0];
    const double later = buffer.sample(59 * 16'667 + 9'000'000, {})[0].pose.position[0];
    EXPECT_NEAR(soon, 59 + 50.0 / 16.667, 0.01);
    EXPECT_EQ(soon, later);
}

TEST(Interpolation, has_nothing_to_show_before_the_first_frame) {
    EXPECT_TRUE(InterpolationBuffer().sample(0, {}).empty());
}

}  // namespace jostle::client
