// SPDX-License-Identifier: MIT
//
// Grabs against the closed form of a critically damped spring.
#include "jostle/modules/point_grab.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/scalar.h"

namespace jostle::modules {
namespace {

using physics::Vec3;

void advance(PointGrab& grab, double h) {
    grab.velocity += grab.pull(h) * h;
    grab.position += grab.velocity * h;
}

TEST(PointGrab, approaches_its_target_like_a_critically_damped_spring) {
    PointGrab grab = make_point_grab(1, {0, 1, 0}, 2);
    ASSERT_TRUE(grab.aim_at({0.05, 1, 0}));
    const double h = 1e-5, w = 2 * physics::pi * 5;
    for (double t = 0; t < 0.1; t += h) advance(grab, h);
    const double left = 0.05 * (1 + w * 0.1) * std::exp(-w * 0.1);
    EXPECT_NEAR(grab.position.x, 0.05 - left, 1e-5);
    for (double t = 0; t < 1; t += 1.0 / 480) advance(grab, 1.0 / 480);
    EXPECT_NEAR(grab.position.x, 0.05, 1e-9);
}

TEST(PointGrab, accelerates_by_at_most_200_m_s2) {
    PointGrab grab = make_point_grab(1, {}, 2);
    ASSERT_TRUE(grab.aim_at({0, 1e6, 0}));
    EXPECT_NEAR(length(grab.pull(1.0 / 480)), 200, 1e-9);
    grab.velocity = {0, -1e6, 0};
    EXPECT_NEAR(length(grab.pull(1.0 / 480)), 200, 1e-9);
}

TEST(PointGrab, refuses_targets_out_of_range) {
    PointGrab grab = make_point_grab(1, {1, 2, 3}, 2);
    EXPECT_FALSE(grab.aim_at({1.1e6, 0, 0}));
    EXPECT_FALSE(grab.aim_at({0, std::nan(""), 0}));
    EXPECT_EQ(grab.target, (Vec3{1, 2, 3}));
}

TEST(PointGrab, is_as_heavy_as_the_object_within_limits) {
    EXPECT_EQ(make_point_grab(1, {}, 3).mass, 3);
    EXPECT_EQ(make_point_grab(1, {}, 0).mass, PointGrab::mass_min);
    EXPECT_EQ(make_point_grab(1, {}, 1e9).mass, PointGrab::mass_max);
}

}  // namespace
}  // namespace jostle::modules
