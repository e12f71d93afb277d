// SPDX-License-Identifier: MIT
#include "modules/crowd/src/avoidance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace jostle::modules::crowd_detail {
namespace {

constexpr float horizon = 2, dt = 1.f / 60;

// The half-plane of one neighbour.
HalfPlane beside(float x, float y, float vx, float vy, float other_vx, float other_vy,
                 float radii) {
    RelativeNeighbors list;
    for (std::size_t k = 0; k < 4; k++) {
        list.x[k] = x, list.y[k] = y;
        list.vx[k] = vx, list.vy[k] = vy;
        list.rx[k] = vx - other_vx, list.ry[k] = vy - other_vy;
        list.radii[k] = radii, list.share[k] = 0.5f;
    }
    list.count = 1;
    HalfPlane plane;
    avoid_agents(list, horizon, dt, &plane);
    return plane;
}

// Smallest distance within the horizon at a relative velocity.
double closest(float dx, float dy, float vx, float vy) {
    const double x{dx}, y{dy}, rx{vx}, ry{vy};
    const double squared = rx * rx + ry * ry;
    const double t = squared > 0 ? std::clamp((x * rx + y * ry) / squared, 0.0, 2.0) : 0;
    return std::hypot(x - rx * t, y - ry * t);
}

TEST(Avoidance, agents_that_approach_head_on_share_the_correction) {
    // 4 m apart, 0.9 m/s each: discs of 1 m would meet after 1.7 s. Both slow down by 0.15 m/s, so
    // that they touch after 2 s.
    const HalfPlane plane = beside(4, 0, 0.9f, 0, -0.9f, 0, 1);
    EXPECT_NEAR(double{plane.x}, -1, 1e-6);
    EXPECT_NEAR(double{plane.offset}, -0.75, 1e-6);
}

TEST(Avoidance, overlapping_agents_separate_in_one_step) {
    const HalfPlane plane = beside(0.9f, 0, 0, 0, 0, 0, 1);
    EXPECT_NEAR(double{plane.x}, -1, 1e-6);
    EXPECT_NEAR(double{plane.offset}, 0.5 * 0.1 * 60, 1e-4);
}

// Any two velocities that obey the half-planes of both agents avoid a collision within the horizon.
TEST(Avoidance, velocities_that_obey_both_planes_do_not_collide) {
    test::Random random(3);
    int sampled = 0;
    for (int k = 0; k < 400; k++) {
        const auto draw = [&](double most) { return static_cast<float>(random.in(-most, most)); };
        const float x = draw(4), y = draw(4), radii = 0.6f;
        if (std::hypot(x, y) < 1.01f * radii) continue;
        const float ax = draw(1.5), ay = draw(1.5), bx = draw(1.5), by = draw(1.5);
        const HalfPlane a = beside(x, y, ax, ay, bx, by, radii);
        const HalfPlane b = beside(-x, -y, bx, by, ax, ay, radii);
        for (int n = 0; n < 50; n++) {
            const float u = draw(2), v = draw(2), s = draw(2), t = draw(2);
            if (a.x * u + a.y * v < a.offset || b.x * s + b.y * t < b.offset) continue;
            sampled++;
            ASSERT_GE(closest(x, y, u - s, v - t), double{radii} - 1e-4);
        }
    }
    EXPECT_GT(sampled, 2000);
}

TEST(Avoidance, wall_limits_the_approach_speed_to_the_gap_per_horizon) {
    const HalfPlane plane = avoid_wall(1, 0, 1, 0.25f, 0.5f, dt);
    EXPECT_EQ(plane.x, -1);
    EXPECT_NEAR(double{plane.offset}, -1.5, 1e-6);
    EXPECT_NEAR(double{avoid_wall(0.2f, 0, 0.2f, 0.25f, 0.5f, dt).offset}, 3,
                1e-4);  // 5 cm in one step
}

}  // namespace
}  // namespace jostle::modules::crowd_detail
