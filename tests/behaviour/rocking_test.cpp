// SPDX-License-Identifier: MIT
//
// What rocks without slipping neither gains nor loses: contacts are centred in time
// (stages/contacts/predicted_pair.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

double tilt_of(const World& world, BodyId body) {
    const Quat q = state_of(world, body).pose.rotation;
    return 2 * std::atan2(q.z, q.w);
}

struct Swing {
    double amplitude;  // rad, largest in the last seconds
    double period;     // s, mean
};

// The last `window` of so many seconds.
Swing swing_of(World& world, BodyId body, double seconds, double window) {
    const int steps = static_cast<int>(seconds * 60 + 0.5);
    double amplitude = 0, first = -1, last = -1, before = tilt_of(world, body);
    int turns = 0;
    for (int i = 1; i <= steps; i++) {
        must(world.step(1.0 / 60));
        const double tilt = tilt_of(world, body);
        if (i > steps - window * 60) amplitude = std::max(amplitude, std::abs(tilt));
        // Upward through zero.
        if (before < 0 && tilt >= 0) {
            const double at = (i - tilt / (tilt - before)) / 60;
            if (first < 0) first = at;
            if (last >= 0) turns++;
            last = at;
        }
        before = tilt;
    }
    return {amplitude, turns > 0 ? (last - first) / turns : 0};
}

// A plank of half extents `half` that lies across something round of radius r, tilted without
// having slipped.
BodyId add_plank(World& world, Vec3 half, double r, double tilt) {
    const Vec3 up{std::sin(tilt), std::cos(tilt), 0}, along{std::cos(tilt), -std::sin(tilt), 0};
    return add(world, {.geometry = Box{half},
                       .position = up * (r + half.y) - along * (r * tilt),
                       .rotation = {0, 0, -std::sin(tilt / 2), std::cos(tilt / 2)},
                       .friction = 2});
}

// Small swings: w^2 = g (r - h) / (k^2 + h^2), with half the thickness h and the radius of gyration
// k. With contacts of the start of each step 0.05 rad became 0.11 in 20 s, and with such as were
// kept for 4 mm of motion 0.22.
TEST(Rocking, plank_on_a_ball_keeps_its_amplitude_for_20_s) {
    const Vec3 half{1, 0.05, 0.3};
    const double r = 0.5;
    const double gyration2 = (half.x * half.x + half.y * half.y) / 3;
    const double period = 2 * pi / std::sqrt(9.81 * (r - half.y) / (gyration2 + half.y * half.y));
    for (const double tilt : {0.02, 0.05, 0.1, 0.2}) {
        World world = make_world({.sleeping = false});
        add(world, {.geometry = Sphere{r}, .type = BodyType::static_body});
        const BodyId plank = add_plank(world, half, r, tilt);
        const Swing swing = swing_of(world, plank, 20, 2);
        EXPECT_NEAR(swing.amplitude, tilt, 0.02 * tilt) << "tilt " << tilt;
        EXPECT_NEAR(swing.period, period, 0.02 * period) << "tilt " << tilt;
    }
}

// At 14 rad/s: 45 swings in 20 s.
TEST(Rocking, small_plate_on_a_ball_keeps_its_amplitude_for_20_s) {
    World world = make_world({.sleeping = false});
    add(world, {.geometry = Sphere{0.3}, .type = BodyType::static_body});
    const BodyId plate = add_plank(world, {0.2, 0.02, 0.2}, 0.3, 0.02);
    const Swing swing = swing_of(world, plate, 20, 2);
    EXPECT_NEAR(swing.amplitude, 0.02, 0.05 * 0.02);
}

// A ball with a weight near its lowest point: the contact runs along its surface.
TEST(Rocking, weighted_ball_keeps_its_amplitude_for_20_s) {
    const double r = 0.5, depth = 0.3, weight = 0.1;
    for (const double tilt : {0.1, 0.3}) {
        World world = make_world({.sleeping = false});
        add_floor(world, 2);
        const BodyId ball = must(world.create_body(
            {.pose = {{-r * tilt, r, 0}, {0, 0, std::sin(tilt / 2), std::cos(tilt / 2)}}},
            {.geometry = Sphere{r}, .material = {2, 0}, .density = 200}));
        must(world.create_shape(ball, {.geometry = Sphere{weight},
                                       .pose = {.position = {0, -depth, 0}},
                                       .material = {2, 0},
                                       .density = 20000}));
        const Swing swing = swing_of(world, ball, 20, 2);
        EXPECT_NEAR(swing.amplitude, tilt, 0.02 * tilt) << "tilt " << tilt;
    }
}

}  // namespace
}  // namespace jostle::test
