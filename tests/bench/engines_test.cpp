// SPDX-License-Identifier: MIT
//
// Runs every engine on small scenes with a known physical result.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/speed/engine_kinds.h"
#include "scenes/src/scene_helpers.h"
#include "tests/support/near.h"

namespace {

using namespace jostle::bench;
using namespace jostle::physics;
using jostle::scenes::dynamic_body;
using jostle::scenes::fixed_box;
using jostle::scenes::join;
using jostle::scenes::SceneBody;
using jostle::test::near;

class EveryEngine : public testing::TestWithParam<const EngineKind*> {
protected:
    void start(bool sleep = false) {
        scene_.world.sleeping = sleep;
        const auto status = engine_->init(scene_);
        ASSERT_TRUE(status.ok()) << status.error().message;
    }
    void run(int steps) {
        for (int k = 0; k < steps; k++) engine_->step();
    }
    // Adds a body with the damping of the benchmark scenes.
    SceneBody& add(SceneBody body) {
        body.body.linear_damping = body.body.angular_damping = 0.05;
        return scene_.bodies.emplace_back(std::move(body));
    }
    SceneBody& add(const Geometry& geometry, Vec3 position = {}, Quat rotation = {}) {
        return add(dynamic_body("body", position, geometry, rotation));
    }
    void add_floor() { add(fixed_box("floor", {0, -1, 0}, {50, 1, 50})); }
    // A post on the floor and an arm that is attached to its side by a joint.
    void add_post_and_arm() {
        add_floor();
        add(Box{{1, 2, 1}}, {0, 2, 0});
        add(Capsule{0.1, 0.4}, {1.6, 3, 0}, from_axis_angle({0, 0, 1}, -pi / 2));
    }

    jostle::scenes::SceneDescription scene_;
    std::unique_ptr<Engine> engine_ = GetParam()->make();
};

TEST_P(EveryEngine, free_fall_is_damped_at_0_05_per_second) {
    add(Sphere{0.5});
    start();
    run(60);
    // v = -g/c (1 - e^(-c t)), c = 0.05 /s, t = 1 s.
    EXPECT_NEAR(engine_->velocity(0).y, -9.81 / 0.05 * (1 - std::exp(-0.05)), 0.01);
}

TEST_P(EveryEngine, box_stopping_distance_matches_friction_0_5) {
    add_floor();
    add(Box{{0.5, 0.1, 0.5}}, {0, 0.1, 0}).body.linear_velocity = {4, 0, 0};
    start();
    run(120);
    // dv/dt = -mu g - c v from v0 = 4 m/s: x = v0/c - mu g/c^2 ln(1 + c v0 / (mu g)).
    const double mu_g = 0.5 * 9.81, c = 0.05;
    EXPECT_NEAR(engine_->pose(1).position.x, 4 / c - mu_g / (c * c) * std::log1p(c * 4 / mu_g),
                0.06);
    EXPECT_NEAR(engine_->velocity(1).x, 0, 1e-3);
}

TEST_P(EveryEngine, capsule_axis_is_y) {
    add_floor();
    add(Capsule{0.25, 1}, {0, 0.25, 0}, from_axis_angle({0, 0, 1}, pi / 2));
    add(Capsule{0.25, 1}, {5, 3, 0});
    start();
    run(60);
    EXPECT_NEAR(engine_->pose(1).position.y, 0.25, 0.02);
    EXPECT_NEAR(engine_->pose(2).position.y, 1.25, 0.02);  // upright on its end
}

// The angle is that of the arm relative to the post: down is the lower limit.
TEST_P(EveryEngine, hinge_stops_at_its_lower_limit) {
    add_post_and_arm();
    join(scene_, "elbow", 1, 2, {{1.1, 3, 0}, {}}, HingeJoint{.limit = {true, -0.5, 1}});
    start();
    run(240);
    const Vec3 out = engine_->pose(2).position - Vec3{1.1, 3, 0};
    EXPECT_NEAR(std::atan2(out.y, out.x), -0.5, 0.05);
    EXPECT_NEAR(length(out), 0.5, 0.01);
}

// The speed is that of the arm relative to the post: 1 rad/s for 1 s, against a weight of 145 N m.
TEST_P(EveryEngine, hinge_motor_raises_the_arm) {
    add_post_and_arm();
    join(scene_, "elbow", 1, 2, {{1.1, 3, 0}, {}},
         HingeJoint{.motor = {.enabled = true, .speed = 1, .max_torque = 2000}});
    start();
    run(60);
    const Vec3 out = engine_->pose(2).position - Vec3{1.1, 3, 0};
    EXPECT_NEAR(std::atan2(out.y, out.x), 1, 0.05);
}

// With a horizontal cone_twist joint, the arm falls by the swing limit and no further.
TEST_P(EveryEngine, shoulder_swing_stops_at_its_cone) {
    add_post_and_arm();
    join(scene_, "shoulder", 1, 2, {{1.1, 3, 0}, from_axis_angle({1, 0, 0}, -pi / 2)},
         ConeTwistJoint{.swing = 0.5, .twist = {true, -0.2, 0.2}});
    start();
    run(240);
    const Vec3 out = engine_->pose(2).position - Vec3{1.1, 3, 0};
    EXPECT_NEAR(std::atan2(out.y, out.x), -0.5, 0.1);
    EXPECT_NEAR(out.z, 0, 0.02);
}

TEST_P(EveryEngine, jointed_bodies_do_not_collide_and_static_anchor_holds) {
    SceneBody& hook = add(Sphere{0.5});
    hook.body.type = BodyType::static_body;
    hook.shapes[0].filter.mask = 0;
    add(Sphere{0.5}, {0, -0.6, 0});
    add(Sphere{0.5}, {0, -1.2, 0});
    join(scene_, "link", 0, 1, {{0, -0.3, 0}, {}}, BallJoint{});
    join(scene_, "link", 1, 2, {{0, -0.9, 0}, {}}, BallJoint{});
    start();
    run(60);
    EXPECT_TRUE(near(engine_->pose(0).position, {}, 0));
    EXPECT_TRUE(near(engine_->pose(1).position, {0, -0.6, 0}, 0.02));
    EXPECT_TRUE(near(engine_->pose(2).position, {0, -1.2, 0}, 0.02));
}

TEST_P(EveryEngine, non_colliding_bodies_fall_through) {
    add_floor();
    add(Sphere{0.5}, {0, 0.6, 0}).shapes[0].filter.mask = 0;
    start();
    run(60);
    EXPECT_LT(engine_->pose(1).position.y, -1);
}

// In ODE a static body has no dBody, and requesting its velocity crashed the program.
TEST_P(EveryEngine, static_bodies_do_not_move) {
    add_floor();
    start(true);
    run(1);
    EXPECT_EQ(length(engine_->velocity(0)), 0);
    EXPECT_TRUE(near(engine_->pose(0).position, {0, -1, 0}, 0));
}

TEST_P(EveryEngine, sleeps_when_allowed_and_wakes_when_driven) {
    add_floor();
    add(Box{}, {0, 0.5, 0});
    start(true);
    EXPECT_GT(engine_->awake(), 0);
    run(300);
    EXPECT_EQ(engine_->awake(), 0);
    engine_->set_velocity(1, {6, 0, 0});
    run(1);
    EXPECT_GT(engine_->awake(), 0);
    EXPECT_GT(engine_->velocity(1).x, 5.8);
}

TEST_P(EveryEngine, does_not_sleep_when_disabled) {
    add_floor();
    add(Box{}, {0, 0.5, 0});
    start();
    run(300);
    EXPECT_GT(engine_->awake(), 0);
}

// Engines reject scenes that they do not support, with an error that names the unsupported part.
// Jostle accepts every scene.
TEST_P(EveryEngine, rejects_scenes_that_are_not_portable) {
    add_floor();
    add(Cylinder{});
    EXPECT_EQ(engine_->init(scene_).ok(), std::string_view(GetParam()->name) == "jostle");
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
