// SPDX-License-Identifier: MIT
#include "jostle/client/interpolation.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

snapshot::QuantizedFrame body_at(std::uint32_t frame, double x) {
    return {.frame = frame,
            .entities = {snapshot::quantize(1, {{x, 0, 0}, {0, 0, 0, 1}}, false, {})}};
}

}  // namespace

TEST(Interpolation, renders_uniform_motion_smoothly_when_frames_arrive_in_bursts) {
    InterpolationBuffer buffer;
    // 1 m/s at 60 Hz; every fourth frame is 30 ms late.
    double last = -1, worst = 0;
    for (int i = 0; i < 900; i++) {
        const std::int64_t due = 1'000'000 + i * 16'667;
        const std::int64_t arrived = due + 2'000 + (i % 4 == 0 ? 30'000 : 0);
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i / 60.0), due, arrived);
        const auto poses = buffer.sample(due + 2'000, {});
        if (i < 300) continue;  // until the delay has settled
        ASSERT_EQ(poses.size(), 1u);
        const double x = poses[0].pose.position[0];
        if (last >= 0) worst = std::max(worst, std::abs(x - last - 1.0 / 60));
        last = x;
    }
    EXPECT_LT(worst, 0.003);  // m; quantization and remaining adaptation
    EXPECT_GT(buffer.clock().delay_ms(), 40);
    EXPECT_LT(buffer.clock().delay_ms(), 50);
}

TEST(Interpolation, extrapolates_for_50_ms_when_frames_stop_and_then_holds) {
    InterpolationBuffer buffer;
    for (int i = 0; i < 60; i++) {
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i / 60.0), i * 16'667, i * 16'667);
        buffer.sample(i * 16'667, {});
    }
    double soon = 0, later = 0;
    for (int k = 1; k < 120; k++) {
        (k < 10 ? soon : later) = buffer.sample((59 + k) * 16'667, {})[0].pose.position[0];
    }
    EXPECT_NEAR(soon, 59 / 60.0 + 0.05, 0.01);
    EXPECT_EQ(soon, later);
}

TEST(Interpolation, teleports_a_body_without_interpolating) {
    InterpolationBuffer buffer;
    for (int i = 0; i < 120; i++) {
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i < 90 ? 1 : 4), i * 16'667,
                   i * 16'667);
        for (int k = 0; k < 4; k++) {
            const double x = buffer.sample(i * 16'667 + k * 4'166, {})[0].pose.position[0];
            EXPECT_TRUE(x == 1 || x == 4) << x;
        }
    }
    EXPECT_EQ(buffer.sample(120 * 16'667, {})[0].pose.position[0], 4);
}

TEST(Interpolation, does_not_smooth_a_teleport_during_a_frame_gap) {
    InterpolationBuffer buffer;
    for (int i = 0; i < 60; i++) {
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), 1), i * 16'667, i * 16'667);
        buffer.sample(i * 16'667, {});
    }
    // A gap of ten frames, after which all arrive; in the fifth the body teleported by 2 m.
    for (int i = 60; i < 70; i++) buffer.sample(i * 16'667, {});
    for (int i = 60; i < 71; i++)
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i < 65 ? 1 : 3), i * 16'667,
                   70 * 16'667);
    const double x = buffer.sample(70 * 16'667, {})[0].pose.position[0];
    EXPECT_EQ(x, 3);
}

TEST(Interpolation, discards_errors_after_a_pause_in_rendering) {
    InterpolationBuffer buffer;
    for (int i = 0; i < 60; i++) {
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i / 60.0), i * 16'667, i * 16'667);
        buffer.sample(i * 16'667, {});
    }
    buffer.sample(66 * 16'667, {});  // extrapolated; then no rendering until
    for (int i = 60; i < 120; i++)
        buffer.add(body_at(static_cast<std::uint32_t>(i + 1), i / 60.0), i * 16'667, i * 16'667);
    const double x = buffer.sample(119 * 16'667, {})[0].pose.position[0];
    EXPECT_NEAR(x, static_cast<double>(buffer.clock().render_time_us()) / 1e6, 0.003);
}

TEST(Interpolation, returns_no_poses_before_the_first_frame) {
    EXPECT_TRUE(InterpolationBuffer().sample(0, {}).empty());
}

}  // namespace jostle::client
