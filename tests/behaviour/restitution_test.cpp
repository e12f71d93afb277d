// SPDX-License-Identifier: MIT
//
// Bounces: a ball dropped from h comes back to e^2 h; equal balls exchange their speeds.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Heights of the ball's lowest point at its first apexes, dropped from 1 m.
std::vector<double> apexes(double restitution, double start, int count, int substeps = 8) {
    World world = make_world({.substeps = substeps});
    add_floor(world, 0, restitution);
    const BodyId ball = add(world, {.geometry = Sphere{0.1},
                                    .position = {0, 1.1 + start, 0},
                                    .friction = 0,
                                    .restitution = restitution});
    std::vector<double> tops;
    Vec3 last = velocity_of(world, ball);
    for (int i = 0; i < 60 * 20 && static_cast<int>(tops.size()) < count; i++) {
        must(world.step(1.0 / 60));
        const BodyState s = state_of(world, ball);
        // In flight h + v^2 / 2g is the apex, whatever the phase of the step.
        if (last.y > 0 && s.linear_velocity.y <= 0)
            tops.push_back(s.center.y - 0.1 +
                           s.linear_velocity.y * s.linear_velocity.y / (2 * 9.81));
        last = s.linear_velocity;
    }
    return tops;
}

TEST(Restitution, bounce_height_decays_by_e_squared) {
    double total = 0;
    int heights = 0;
    for (int phase = 0; phase < 16; phase++) {  // a single phase of the step says little
        const double start = phase * 0.005;
        const auto tops = apexes(0.8, start, 5);
        ASSERT_EQ(tops.size(), 5u);
        double expected = 1 + start;
        for (const double top : tops) {
            expected *= 0.64;
            const double error = absolute(top - expected) / expected;
            EXPECT_LT(error, 0.08) << "phase " << phase << " at " << expected << " m";
            total += error;
            heights++;
        }
    }
    RecordProperty("mean_relative_error", std::to_string(total / heights));
    EXPECT_LT(total / heights, 0.03);
}

TEST(Restitution, perfectly_elastic_ball_keeps_its_height) {
    const auto tops = apexes(1, 0, 10);
    ASSERT_EQ(tops.size(), 10u);
    RecordProperty("tenth_apex_m", std::to_string(tops.back()));
    EXPECT_NEAR(tops.back(), 1, 0.1);
}

TEST(Restitution, zero_restitution_does_not_bounce) {
    World world = make_world();
    add_floor(world);
    const BodyId ball = add(world, {.geometry = Sphere{0.1}, .position = {0, 1.1, 0}});
    double highest = 0;
    bool landed = false;
    for (int i = 0; i < 180; i++) {
        must(world.step(1.0 / 60));
        const double bottom = position_of(world, ball).y - 0.1;
        landed = landed || bottom < 0.005;
        if (landed) highest = maximum(highest, bottom);
    }
    ASSERT_TRUE(landed);
    EXPECT_LT(highest, 0.005);
}

TEST(Restitution, equal_balls_exchange_velocities_head_on) {
    World world = make_world({.gravity = {}});
    const Vec3 n = normalized(Vec3{0.8, 0.1, 0.6});
    const auto ball = [&](Vec3 position, Vec3 velocity) {
        return add(world, {.geometry = Sphere{0.1},
                           .position = position,
                           .velocity = velocity,
                           .friction = 0,
                           .restitution = 1});
    };
    const BodyId a = ball({}, n * 5), b = ball(n * 2, {});
    run(world, 1);
    EXPECT_TRUE(near(velocity_of(world, a), {}, 0.05));
    EXPECT_TRUE(near(velocity_of(world, b), n * 5, 0.05));
}

}  // namespace
}  // namespace jostle::test
