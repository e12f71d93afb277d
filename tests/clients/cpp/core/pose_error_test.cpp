// SPDX-License-Identifier: MIT
#include "jostle/client/pose_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::client {
namespace {

const snapshot::Pose right_pose{{1, 2, 3}, {0, 0, std::sin(0.1), std::cos(0.1)}};

PoseError metres(double x) {
    return {{x, 0, 0}, {0, 0, 0, 1}};
}

}  // namespace

TEST(PoseError, applied_to_the_target_pose_returns_the_rendered_pose) {
    const snapshot::Pose shown{{1.5, 2, 2}, {std::sin(0.3), 0, 0, std::cos(0.3)}};
    const snapshot::Pose again = apply_error(right_pose, pose_error(shown, right_pose));
    for (std::size_t k = 0; k < 3; k++) EXPECT_NEAR(again.position[k], shown.position[k], 1e-12);
    for (std::size_t k = 0; k < 4; k++) EXPECT_NEAR(again.rotation[k], shown.rotation[k], 1e-12);
    EXPECT_TRUE(pose_error(right_pose, right_pose).none());
}

TEST(PoseError, small_error_halves_in_100_ms_and_vanishes_in_one_second) {
    EXPECT_NEAR(decayed(metres(0.01), {}, 0.1).position[0], 0.005, 1e-9);
    EXPECT_TRUE(decayed(metres(0.01), {}, 1.0).none());
}

TEST(PoseError, large_error_is_corrected_at_1_1_m_per_s_or_0_35_of_the_body_speed) {
    EXPECT_NEAR(decayed(metres(2), {}, 0.1).position[0], 2 - 0.11, 1e-9);
    EXPECT_NEAR(decayed(metres(8), {.speed = 20, .spin = 0}, 0.1).position[0], 8 - 0.7, 1e-9);
    const PoseError turned{{}, {0, std::sin(1.0), 0, std::cos(1.0)}};  // 2 rad
    const PoseError later = decayed(turned, {}, 0.1);
    EXPECT_NEAR(2 * std::asin(later.rotation[1]), 2 - 0.15, 1e-9);
}

TEST(PoseError, error_that_needs_more_than_three_seconds_is_not_smoothed) {
    EXPECT_FALSE(smoothable_error(metres(3.2), {}).none());
    EXPECT_TRUE(smoothable_error(metres(3.4), {}).none());
    EXPECT_FALSE(smoothable_error(metres(3.4), {.speed = 10, .spin = 0}).none());
}

}  // namespace jostle::client
