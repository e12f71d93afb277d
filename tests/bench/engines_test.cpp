// SPDX-License-Identifier: MIT
//
// Every engine is given the same scene: small ones whose outcome physics says.
#include <gtest/gtest.h>

#include <cmath>

#include "speed/engine_kinds.h"
#include "support/near.h"

namespace {

using namespace jostle::bench;
using jostle::physics::Box;
using jostle::physics::Capsule;
using jostle::physics::from_axis_angle;
using jostle::physics::Sphere;
using jostle::physics::Transform;
using jostle::physics::Vec3;
using jostle::test::near;

constexpr double pi = jostle::physics::pi;

class EveryEngine : public testing::TestWithParam<const EngineKind*> {
protected:
    void start(bool sleep = false) {
        const auto status = engine_->init(scene_, 1, sleep);
        ASSERT_TRUE(status.ok()) << status.error().message;
    }
    void run(int steps) {
        for (int k = 0; k < steps; k++) engine_->step();
    }
    void add_floor() {
        scene_.bodies.push_back(
            {.form = Box{{50, 1, 50}}, .pose = {.position = {0, -1, 0}}, .fixed = true});
    }

    SceneDescription scene_;
    std::unique_ptr<Engine> engine_ = GetParam()->make();
};

TEST_P(EveryEngine, free_fall_is_damped_at_a_twentieth_a_second) {
    scene_.bodies.push_back({.form = Sphere{0.5}});
    start();
    run(60);
    // v = -g/c (1 - e^(-c t)), c = 0.05 /s, t = 1 s.
    EXPECT_NEAR(engine_->velocity(0).y, -9.81 / 0.05 * (1 - std::exp(-0.05)), 0.01);
}

TEST_P(EveryEngine, box_slides_as_far_as_friction_of_one_half_says) {
    add_floor();
    scene_.bodies.push_back(
        {.form = Box{{0.5, 0.1, 0.5}}, .pose = {.position = {0, 0.1, 0}}, .velocity = {4, 0, 0}});
    start();
    run(120);
    // dv/dt = -mu g - c v from v0 = 4 m/s: x = v0/c - mu g/c^2 ln(1 + c v0 / (mu g)).
    const double mu_g = 0.5 * 9.81, c = 0.05;
    EXPECT_NEAR(engine_->pose(1).position.x, 4 / c - mu_g / (c * c) * std::log1p(c * 4 / mu_g),
                0.06);
    EXPECT_NEAR(engine_->velocity(1).x, 0, 1e-3);
}

TEST_P(EveryEngine, capsules_lie_along_y) {
    add_floor();
    const Transform lying{{0, 0.25, 0}, from_axis_angle({0, 0, 1}, pi / 2)};
    scene_.bodies.push_back({.form = Capsule{0.25, 1}, .pose = lying});
    scene_.bodies.push_back({.form = Capsule{0.25, 1}, .pose = {.position = {5, 3, 0}}});
    start();
    run(60);
    EXPECT_NEAR(engine_->pose(1).position.y, 0.25, 0.02);
    EXPECT_NEAR(engine_->pose(2).position.y, 1.25, 0.02);  // upright on its end
}

// The angle is that of the arm against the post: down is the lower limit.
TEST_P(EveryEngine, hinge_stops_at_its_lower_limit) {
    add_floor();
    scene_.bodies.push_back({.form = Box{{1, 2, 1}}, .pose = {.position = {0, 2, 0}}});
    const Transform arm{{1.6, 3, 0}, from_axis_angle({0, 0, 1}, -pi / 2)};
    scene_.bodies.push_back({.form = Capsule{0.1, 0.4}, .pose = arm});
    scene_.joints.push_back({.kind = SceneJointKind::hinge,
                             .a = 1,
                             .b = 2,
                             .anchor = {1.1, 3, 0},
                             .axis = {0, 0, 1},
                             .normal = {1, 0, 0},
                             .lower = -0.5,
                             .upper = 1});
    start();
    run(240);
    const Vec3 out = engine_->pose(2).position - Vec3{1.1, 3, 0};
    EXPECT_NEAR(std::atan2(out.y, out.x), -0.5, 0.05);
    EXPECT_NEAR(length(out), 0.5, 0.01);
}

// A shoulder that points sideways lets its arm fall by the swing and no further.
TEST_P(EveryEngine, shoulder_swings_as_far_as_its_cone) {
    add_floor();
    scene_.bodies.push_back({.form = Box{{1, 2, 1}}, .pose = {.position = {0, 2, 0}}});
    const Transform arm{{1.6, 3, 0}, from_axis_angle({0, 0, 1}, -pi / 2)};
    scene_.bodies.push_back({.form = Capsule{0.1, 0.4}, .pose = arm});
    scene_.joints.push_back({.kind = SceneJointKind::cone_twist,
                             .a = 1,
                             .b = 2,
                             .anchor = {1.1, 3, 0},
                             .axis = {1, 0, 0},
                             .normal = {0, 1, 0},
                             .swing = 0.5,
                             .lower = -0.2,
                             .upper = 0.2});
    start();
    run(240);
    const Vec3 out = engine_->pose(2).position - Vec3{1.1, 3, 0};
    EXPECT_NEAR(std::atan2(out.y, out.x), -0.5, 0.1);
    EXPECT_NEAR(out.z, 0, 0.02);
}

TEST_P(EveryEngine, jointed_bodies_do_not_collide_and_a_fixed_one_holds) {
    scene_.bodies.push_back({.form = Sphere{0.5}, .fixed = true, .collides = false});
    scene_.bodies.push_back({.form = Sphere{0.5}, .pose = {.position = {0, -0.6, 0}}});
    scene_.bodies.push_back({.form = Sphere{0.5}, .pose = {.position = {0, -1.2, 0}}});
    scene_.joints.push_back({.a = 0, .b = 1, .anchor = {0, -0.3, 0}});
    scene_.joints.push_back({.a = 1, .b = 2, .anchor = {0, -0.9, 0}});
    start();
    run(60);
    EXPECT_TRUE(near(engine_->pose(0).position, {}, 0));
    EXPECT_TRUE(near(engine_->pose(1).position, {0, -0.6, 0}, 0.02));
    EXPECT_TRUE(near(engine_->pose(2).position, {0, -1.2, 0}, 0.02));
}

TEST_P(EveryEngine, bodies_that_collide_with_nothing_fall_through) {
    add_floor();
    scene_.bodies.push_back(
        {.form = Sphere{0.5}, .pose = {.position = {0, 0.6, 0}}, .collides = false});
    start();
    run(60);
    EXPECT_LT(engine_->pose(1).position.y, -1);
}

// In ODE a fixed body is none at all, and asking one for its velocity ended the program.
TEST_P(EveryEngine, fixed_bodies_stand_still) {
    add_floor();
    start(true);
    run(1);
    EXPECT_EQ(length(engine_->velocity(0)), 0);
    EXPECT_TRUE(near(engine_->pose(0).position, {0, -1, 0}, 0));
}

TEST_P(EveryEngine, sleeps_when_it_may_and_wakes_when_it_is_driven) {
    add_floor();
    scene_.bodies.push_back({.form = Box{}, .pose = {.position = {0, 0.5, 0}}});
    start(true);
    EXPECT_GT(engine_->awake(), 0);
    run(300);
    EXPECT_EQ(engine_->awake(), 0);
    engine_->set_velocity(1, {6, 0, 0});
    run(1);
    EXPECT_GT(engine_->awake(), 0);
    EXPECT_GT(engine_->velocity(1).x, 5.8);
}

TEST_P(EveryEngine, never_sleeps_when_it_may_not) {
    add_floor();
    scene_.bodies.push_back({.form = Box{}, .pose = {.position = {0, 0.5, 0}}});
    start();
    run(300);
    EXPECT_GT(engine_->awake(), 0);
}

std::vector<const EngineKind*> built_in() {
    std::vector<const EngineKind*> kinds;
    for (const EngineKind& kind : engine_kinds())
        if (kind.make) kinds.push_back(&kind);
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(All, EveryEngine, testing::ValuesIn(built_in()),
                         [](const auto& test) { return std::string(test.param->name); });

}  // namespace
