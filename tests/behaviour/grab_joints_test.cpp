// SPDX-License-Identifier: MIT
//
// A hand that pulls a point of a body, against closed forms and against whatever a client sends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

JointId grab(World& world, BodyId body, Vec3 anchor, const GrabJoint& kind) {
    return must(
        world.create_joint({.body_b = body, .frame_b = {.position = anchor}, .kind = kind}));
}

// Undamped: a ball swings about the target with the spring's frequency.
TEST(Grab, oscillates_at_its_frequency) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .sleep_allowed = false});
    grab(world, ball, {}, {.target = {1, 0, 0}, .spring = {1, 0}});
    double last = 0, furthest = 0;
    int turns = 0;
    for (int i = 0; i < 60 * 10; i++) {
        must(world.step(1.0 / 60));
        const double v = velocity_of(world, ball).x;
        if (last < 0 && v >= 0) turns++;
        last = v;
        furthest = std::max(furthest, position_of(world, ball).x);
    }
    EXPECT_NEAR(turns, 10, 1);
    EXPECT_NEAR(furthest, 2, 0.01);
}

// 2 kg, at most 10 N: 5 m/s^2, however far the target is.
TEST(Grab, respects_its_maximum_force) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .sleep_allowed = false});
    must(world.set_mass(ball, 2));
    const JointId joint =
        grab(world, ball, {}, {.target = {1000, 0, 0}, .spring = {5, 1}, .max_force = 10});
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, ball).x, 5, 1e-3);
    EXPECT_NEAR(must(world.joint(joint)).force.x, 10, 1e-3);
}

// Hooke: it hangs g / (2 pi f)^2 below the target.
TEST(Grab, static_deflection_follows_hooke) {
    World world = make_world();
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .sleep_allowed = false});
    grab(world, ball, {}, {.spring = {1, 1}});
    run(world, 10);
    EXPECT_NEAR(position_of(world, ball).y, -9.81 / (4 * pi * pi), 1e-3);
}

TEST(Grab, angular_damping_is_a_rate) {
    World world = make_world({.gravity = {}});
    const BodyId ball =
        add(world, {.geometry = Sphere{0.5}, .spin = {0, 3, 0}, .sleep_allowed = false});
    grab(world, ball, {}, {.spring = {5, 1}, .angular_damping = 0.5});
    run(world, 2);
    EXPECT_NEAR(state_of(world, ball).angular_velocity.y, 3 * std::exp(-1.0), 0.005);
}

struct Held {
    const char* what;
    ShapeDef shape;
    Vec3 anchor;  // in the body
};

// From a feather of a tenth of a gram to 80 tonnes, held by the middle, by a corner, by a far
// point.
std::vector<Held> held_bodies() {
    return {
        {"feather", {.geometry = Sphere{0.05}, .density = 0.2}, {0, 0.05, 0}},
        {"ball by its middle", {.geometry = Sphere{0.5}}, {}},
        {"box by a corner", {.geometry = Box{}}, {0.5, 0.5, 0.5}},
        {"long thin rod by its end", {.geometry = Capsule{0.05, 2}, .density = 7800}, {0, 2.05, 0}},
        {"80 tonnes by a corner", {.geometry = Box{{1, 1, 1}}, .density = 10000}, {1, 1, 1}},
    };
}

GrabJoint hand_of(const World& world, BodyId body, Vec3 target) {
    return {.target = target,
            .spring = {5, 1},
            .max_force = state_of(world, body).mass * 200,
            .angular_damping = 4};
}

TEST(Grab, moves_any_mass_to_the_target_and_stops) {
    for (const Held& held : held_bodies()) {
        SCOPED_TRACE(held.what);
        World world = make_world({.gravity = {}});
        const BodyId body = must(world.create_body({}, held.shape));
        const Vec3 target = held.anchor + Vec3{0.5, -0.25, 0.25};
        const JointId joint = grab(world, body, held.anchor, hand_of(world, body, target));
        const auto distance = [&] { return length(must(world.joint(joint)).offset - target); };
        double furthest = distance();
        const double begin = furthest;
        for (int tick = 0; tick < 600; tick++) {
            must(world.step(1.0 / 60));
            furthest = std::max(furthest, distance());
        }
        EXPECT_LE(furthest, begin * 1.05);
        EXPECT_LT(distance(), 0.005);
        EXPECT_LT(length(velocity_of(world, body)), 0.01);
    }
}

TEST(Grab, jumping_target_never_makes_a_body_diverge) {
    std::vector<Held> all = held_bodies();
    all.push_back({"ball by a point 100 m away", {.geometry = Sphere{0.3}}, {100, 0, 0}});
    for (const Held& held : all) {
        SCOPED_TRACE(held.what);
        World world = make_world({.gravity = {}});
        const BodyId body = must(world.create_body({}, held.shape));
        const JointId joint = grab(world, body, held.anchor, {});
        double fastest = 0;
        for (int tick = 0; tick < 1200; tick++) {
            // 10 m to and fro, fifteen times a second: no human hand, but any client may send it.
            const Vec3 target = held.anchor + Vec3{tick / 2 % 2 ? 10.0 : 0.0, 0, 0};
            must(world.set_joint(joint, hand_of(world, body, target)));
            must(world.step(1.0 / 60));
            fastest = std::max(fastest, length(velocity_of(world, body)));
        }
        // What a spring of 10 m gives at most: 10 m * omega.
        EXPECT_LT(fastest, 10 * 2 * pi * 5);
        EXPECT_TRUE(is_finite(state_of(world, body).pose));
        // The hand holds still again: so does the body.
        must(world.set_joint(joint, hand_of(world, body, held.anchor)));
        run(world, 10);
        EXPECT_LT(length(must(world.joint(joint)).offset - held.anchor), 0.01);
    }
}

// A joint to the world needs no body there: it sleeps, is saved, and goes with its body.
TEST(Grab, world_grab_is_saved_and_destroyed_with_its_body) {
    World world = make_world();
    const BodyId ball = add(world, {.geometry = Sphere{0.5}});
    const JointId joint = grab(world, ball, {}, {.target = {0, 1, 0}, .spring = {3, 1}});
    run(world, 1);
    World loaded = must(load(save(world)));
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    run(world, 5);
    run(loaded, 5);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    EXPECT_FALSE(state_of(world, ball).awake);
    must(world.set_joint(joint, GrabJoint{.target = {3, 1, 0}, .spring = {3, 1}}));
    run(world, 3);
    EXPECT_NEAR(position_of(world, ball).x, 3, 0.01) << "a new target wakes it";
    must(world.destroy_body(ball));
    EXPECT_FALSE(world.contains(joint));
    EXPECT_TRUE(world.joints().empty());
}

// A pendulum whose pivot is a point of the world.
TEST(WorldJoints, support_every_joint_kind) {
    World world = make_world();
    const BodyId ball =
        add(world, {.geometry = Sphere{0.1}, .position = {2, 3, 0}, .sleep_allowed = false});
    const JointId joint = must(world.create_joint({.body_b = ball,
                                                   .frame_a = {.position = {0, 3, 0}},
                                                   .frame_b = {.position = {-2, 0, 0}},
                                                   .kind = BallJoint{}}));
    double lowest = 9;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        lowest = std::min(lowest, position_of(world, ball).y);
    }
    EXPECT_NEAR(lowest, 1, 0.01);
    EXPECT_LT(must(world.joint(joint)).separation, 1e-3);
    EXPECT_FALSE(world.create_joint({.body_a = ball}).ok()) << "the world is a, never b";
}

// A lamp that hangs on the world rests against a crate. The crate is taken away and the lamp
// swings: the crate sleeps for itself. A step of another length does not kick the lamp.
TEST(WorldJoints, island_with_a_world_joint_can_split_and_change_its_substeps) {
    World world = make_world();
    add_floor(world);
    const BodyId crate = add(world, {.geometry = Box{{0.5, 0.5, 0.5}}, .position = {0, 0.5, 0}});
    const BodyId lamp = add(world, {.geometry = Sphere{0.5}, .position = {0, 1.5, 0}});
    must(world.create_joint({.body_b = lamp,
                             .frame_a = {.position = {0, 4, 0}},
                             .kind = DistanceJoint{.min_length = 2.5, .max_length = 2.5}}));
    run(world, 0.2);
    run(world, 0.1, 90);
    EXPECT_LT(length(velocity_of(world, lamp)), 1e-3);
    must(world.set_pose(crate, {.position = {5, 0.5, 0}}));
    must(world.set_linear_velocity(lamp, {0, 0, 1}));
    run(world, 4);
    EXPECT_FALSE(state_of(world, crate).awake);
    EXPECT_TRUE(state_of(world, lamp).awake);
    EXPECT_NEAR(length(position_of(world, lamp) - Vec3{0, 4, 0}), 2.5, 1e-3);
}

}  // namespace
}  // namespace jostle::test
