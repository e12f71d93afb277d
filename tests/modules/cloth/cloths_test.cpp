// SPDX-License-Identifier: MIT
//
// Cloth in a world: loads, momentum, balls, contact, wind, tearing and sleep.
#include "jostle/modules/cloth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/modules/cloth/cloth_world.h"

namespace jostle::modules {
namespace {

using namespace physics;

TEST(Cloths, carry_a_bar_without_surplus_stretch) {
    ClothWorld w({.sleeping = false});
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 51,
                                                        .columns = 11,
                                                        .origin = {0, 5, 0},
                                                        .across = {0.5, 0, 0},
                                                        .down = {0, -1, 0}},
                                               .damping = 1})
                               .value();
    const BodyId bar = w.box({0.25, 3.98, 0}, 5, {0.25, 0.02, 0.02});
    for (std::uint32_t c = 0; c < 11; c++) {
        w.pin(cloth, c);
        w.cloths
            ->attach(w.world, cloth,
                     {.vertex = 550 + c, .body = bar, .point = {0.05 * c - 0.25, 0.02, 0}})
            .expect();
    }
    w.run(15);
    // The cloth's own weight is 0.1 kg: (5 + 0.1 / 2) g over 0.5 m of width.
    const double stretch = 5.05 * g / 0.5 / 5000;
    EXPECT_NEAR(4 - w.cloths->positions(cloth)[555].y, stretch, 0.02 * stretch);
    EXPECT_NEAR(w.world.body(bar)->center.y, 3.98 - stretch, 0.001);
}

TEST(Cloths, conserve_momentum_with_bodies) {
    ClothWorld w({.gravity = {}});
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 21,
                                                        .columns = 21,
                                                        .origin = {-0.5, 0, -0.5},
                                                        .across = {1, 0, 0},
                                                        .down = {0, 0, 1}},
                                               .damping = 0})
                               .value();
    const BodyId corner = w.box({-0.6, 0, -0.5}, 0.5, {0.1, 0.1, 0.1});
    w.cloths->attach(w.world, cloth, {.vertex = 0, .body = corner, .point = {0.1, 0, 0}}).expect();
    const BodyId ball = w.ball({0, 0.5, 0}, 0.3, 0.1, {1, -10, 0.5});
    const Vec3 before = w.momentum(ball);
    w.run(1);
    const Vec3 after = w.momentum(ball) + w.momentum(corner) + w.momentum(cloth);
    EXPECT_LT(length(after - before), 1e-6 * length(before));
    EXPECT_GT(w.momentum(ball).y, 0.99 * before.y);
    EXPECT_GT(length(w.momentum(corner)), 1e-3);
}

// Thrown at a sheet from anywhere, a ball never passes it.
TEST(Cloths, stop_balls_at_50_metres_per_second) {
    int passed = 0;
    std::uint32_t seed = 1;
    const auto random = [&] {
        seed = seed * 1664525u + 1013904223u;
        return (seed >> 8) / 16777216.0;
    };
    for (int n = 0; n < 20; n++) {
        ClothWorld w;
        const ClothKey cloth = w.cloths
                                   ->add(w.world, {.grid = {.rows = 21,
                                                            .columns = 21,
                                                            .origin = {-0.5, 0, -0.5},
                                                            .across = {1, 0, 0},
                                                            .down = {0, 0, 1}}})
                                   .value();
        w.pin_border(cloth);
        const Vec3 target{0.6 * random() - 0.3, 0, 0.6 * random() - 0.3};
        const Vec3 from{random() - 0.5, 1 + random(), random() - 0.5};
        const double mass = 0.02 + 0.3 * random();
        const BodyId ball = w.ball(from, mass, 0.06, normalized(target - from) * 50);
        double least = 1;
        for (int k = 0; k < 30; k++) {
            w.world.step(dt).expect();
            least = std::min(least, w.world.body(ball)->center.y);
        }
        const double y = w.world.body(ball)->center.y;
        if (y < -0.5 || least < -1) {
            passed++;
        }
    }
    EXPECT_EQ(passed, 0);
}

TEST(Cloths, carry_a_heavy_ball_in_a_hammock) {
    ClothWorld w;
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 31,
                                                        .columns = 31,
                                                        .origin = {-0.75, 1, -0.75},
                                                        .across = {1.5, 0, 0},
                                                        .down = {0, 0, 1.5},
                                                        .width = 1.6,
                                                        .height = 1.6},
                                               .damping = 1})
                               .value();
    w.pin_border(cloth);
    const BodyId ball = w.ball({0, 1.3, 0}, 10, 0.2);
    w.run(20);
    const BodyState state = w.world.body(ball).value();
    double closest = 1;
    for (const Vec3 p : w.cloths->positions(cloth))
        closest = std::min(closest, length(p - state.center) - 0.2);
    EXPECT_GT(state.center.y, 0.6);
    EXPECT_LT(length(state.linear_velocity), 0.1);
    EXPECT_GT(closest, 0.004);
}

TEST(Cloths, drape_over_a_box_and_sleep) {
    ClothWorld w;
    w.world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    w.world
        .create_body({.type = BodyType::static_body, .pose = {{0, 0.5, 0}, {}}},
                     {.geometry = Box{{0.3, 0.5, 0.3}}})
        .value();
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 31,
                                                        .columns = 31,
                                                        .origin = {-0.6, 1.2, -0.6},
                                                        .across = {1.2, 0, 0},
                                                        .down = {0, 0, 1.2}},
                                               .damping = 2})
                               .value();
    w.run(10);
    double lowest = 1, deepest = 1;
    for (const Vec3 p : w.cloths->positions(cloth)) {
        lowest = std::min(lowest, p.y);
        const Vec3 q = abs(p - Vec3{0, 0.5, 0}) - Vec3{0.3, 0.5, 0.3};
        deepest = std::min(deepest, std::max(q.x, std::max(q.y, q.z)));
    }
    EXPECT_GT(lowest, 0.3);
    EXPECT_LT(lowest, 0.9);
    EXPECT_GT(deepest, 0.004);
    EXPECT_FALSE(w.cloths->is_awake(cloth));
}

TEST(Cloths, wave_in_the_wind) {
    ClothWorld w;
    w.world.create_field({.force = UniformWind{.velocity = {15, 0, 3}}}).value();
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 16,
                                                        .columns = 24,
                                                        .origin = {0, 5, 0},
                                                        .across = {1.5, 0, 0},
                                                        .down = {0, -1, 0}}})
                               .value();
    for (std::uint32_t r = 0; r < 16; r++) w.pin(cloth, 24 * r);
    w.run(3);
    double mean = 0;
    for (const Vec3 p : w.cloths->positions(cloth)) mean += p.x / (16 * 24);
    EXPECT_GT(mean, 0.6);
    double most = 0;
    for (const Vec3 v : w.cloths->velocities(cloth)) most = std::max(most, length(v));
    EXPECT_LT(most, 50);
    EXPECT_TRUE(w.cloths->is_awake(cloth));
}

TEST(Cloths, tear_above_their_breaking_load) {
    for (const double mass : {1.0, 30.0}) {
        ClothWorld w;
        const ClothKey cloth = w.cloths
                                   ->add(w.world, {.grid = {.rows = 21,
                                                            .columns = 11,
                                                            .origin = {0, 5, 0},
                                                            .across = {0.5, 0, 0},
                                                            .down = {0, -1, 0}},
                                                   .breaking_load = 300})
                                   .value();
        const BodyId bar = w.box({0.25, 3.98, 0}, mass, {0.25, 0.02, 0.02});
        for (std::uint32_t c = 0; c < 11; c++) {
            w.pin(cloth, c);
            w.cloths
                ->attach(w.world, cloth,
                         {.vertex = 220 + c, .body = bar, .point = {0.05 * c - 0.25, 0.02, 0}})
                .expect();
        }
        std::size_t torn = 0;
        for (int n = 0; n < 120; n++) {
            w.world.step(dt).expect();
            for (const ClothEvent& event : w.cloths->events()) torn += event.threads;
        }
        EXPECT_EQ(torn > 0, mass * g / 0.5 > 300) << torn;
        EXPECT_EQ(w.world.body(bar)->center.y<3, mass * g / 0.5> 300);
    }
}

TEST(Cloths, hold_a_resting_body_asleep_and_wake_with_it) {
    ClothWorld w;
    const ClothKey cloth = w.cloths
                               ->add(w.world, {.grid = {.rows = 11,
                                                        .columns = 5,
                                                        .origin = {0, 5, 0},
                                                        .across = {0.4, 0, 0},
                                                        .down = {0, -1, 0}},
                                               .damping = 3})
                               .value();
    const BodyId load = w.box({0.2, 3.9, 0}, 2, {0.2, 0.1, 0.1});
    for (std::uint32_t c = 0; c < 5; c++) {
        w.pin(cloth, c);
        w.cloths
            ->attach(w.world, cloth,
                     {.vertex = 50 + c, .body = load, .point = {0.1 * c - 0.2, 0.1, 0}})
            .expect();
    }
    w.run(6);
    EXPECT_FALSE(w.world.body(load)->awake);
    EXPECT_FALSE(w.cloths->is_awake(cloth));
    w.world.apply_impulse(load, {4, 0, 0}, w.world.body(load)->center).expect();
    w.run(0.2);
    EXPECT_TRUE(w.cloths->is_awake(cloth));
}

}  // namespace
}  // namespace jostle::modules
