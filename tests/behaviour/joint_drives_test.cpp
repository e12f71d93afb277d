// SPDX-License-Identifier: MIT
//
// Balls and cone-twists that are driven to an orientation, or rub, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId ball_body(World& world, Vec3 spin = {}) {
    return add(world, {.geometry = Sphere{0.5}, .spin = spin, .sleep_allowed = false});
}
JointId join_to_world(World& world, BodyId body, const JointKind& kind) {
    return must(world.create_joint({.body_b = body, .kind = kind}));
}
double turn_between(Quat a, Quat b) {
    const Quat q = conjugate(a) * b;
    return 2 * std::atan2(length(Vec3{q.x, q.y, q.z}), std::abs(q.w));
}

TEST(Drive, ball_joint_drive_reaches_and_holds_its_target) {
    for (const double angle : {0.5, 2.0, 3.0}) {
        World world = make_world({.gravity = {}});
        const BodyId body = ball_body(world);
        const Quat target = from_axis_angle(normalized(Vec3{1, 2, -1}), angle);
        join_to_world(world, body, BallJoint{.drive = {.spring = {2, 1}, .target = target}});
        run(world, 3);
        EXPECT_LT(turn_between(state_of(world, body).pose.rotation, target), 1e-3) << angle;
        EXPECT_LT(length(state_of(world, body).angular_velocity), 1e-3);
    }
}

// Undamped, it swings with the spring's frequency.
TEST(Drive, oscillates_at_its_frequency) {
    World world = make_world({.gravity = {}});
    const BodyId body = ball_body(world);
    const Quat target = from_axis_angle({0, 0, 1}, 0.5);
    join_to_world(world, body, BallJoint{.drive = {.spring = {1, 0}, .target = target}});
    double last = 0, first = -1, latest = 0;
    int times = 0;
    for (int i = 1; i <= 600; i++) {
        must(world.step(1.0 / 60));
        const double w = state_of(world, body).angular_velocity.z;
        if (last < 0 && w >= 0) {
            latest = (i - w / (w - last)) / 60;
            if (first < 0)
                first = latest;
            else
                times++;
        }
        last = w;
    }
    EXPECT_NEAR((latest - first) / times, 1, 0.01);
}

// A torque of I rad/s^2 at most.
TEST(Drive, respects_its_maximum_torque) {
    for (const bool cone : {false, true}) {
        World world = make_world({.gravity = {}});
        const BodyId body = ball_body(world);
        const double inertia = state_of(world, body).inertia.z.z;
        const RotationDrive drive{
            .spring = {5, 1}, .target = from_axis_angle({0, 0, 1}, 3), .max_torque = inertia};
        const JointId joint = join_to_world(
            world, body,
            cone ? JointKind(ConeTwistJoint{.swing = pi, .twist = {false, 0, 0}, .drive = drive})
                 : JointKind(BallJoint{.drive = drive}));
        run(world, 1);
        EXPECT_NEAR(state_of(world, body).angular_velocity.z, 1, 0.01);
        EXPECT_NEAR(must(world.joint(joint)).torque.z, inertia, 0.01 * inertia);
    }
}

// A spring that may pull with I rad/s^2 at most, about a hinge or a six-dof's lone turn.
TEST(Drive, axis_spring_respects_its_maximum_torque) {
    for (const bool hinge : {true, false}) {
        World world = make_world({.gravity = {}});
        const BodyId body = ball_body(world);
        const double inertia = state_of(world, body).inertia.z.z;
        SixDofJoint six;
        six.axes->rotation_z = {
            .free = true, .spring = {5, 1}, .spring_target = 3, .spring_max_force = inertia};
        const HingeJoint about{.spring = {5, 1}, .spring_angle = 3, .spring_max_torque = inertia};
        const JointId joint = join_to_world(world, body, hinge ? JointKind(about) : JointKind(six));
        run(world, 1);
        EXPECT_NEAR(state_of(world, body).angular_velocity.z, 1, 0.01);
        EXPECT_NEAR(must(world.joint(joint)).torque.z, inertia, 0.01 * inertia);
    }
}

// 1 m/s^2 at most; without a bound the spring is there in a moment.
TEST(Drive, slider_spring_respects_its_maximum_force) {
    for (const bool bounded : {true, false}) {
        World world = make_world({.gravity = {}});
        const BodyId body = ball_body(world);
        const double mass = state_of(world, body).mass;
        join_to_world(
            world, body,
            SliderJoint{
                .spring = {5, 1}, .spring_travel = 2, .spring_max_force = bounded ? mass : 0});
        run(world, 1);
        if (bounded)
            EXPECT_NEAR(state_of(world, body).linear_velocity.z, 1, 0.01);
        else
            EXPECT_NEAR(state_of(world, body).pose.position.z, 2, 1e-3);
    }
}

// The cone stops what the drive would turn too far.
TEST(Drive, stays_within_the_cone) {
    World world = make_world({.gravity = {}});
    const BodyId body = ball_body(world);
    const JointId joint = join_to_world(
        world, body,
        ConeTwistJoint{.swing = 0.4,
                       .drive = {.spring = {3, 1}, .target = from_axis_angle({0, 0, 1}, 1)}});
    run(world, 3);
    EXPECT_NEAR(must(world.joint(joint)).swing, 0.4, 0.01);
}

// 2 rad/s^2 against the spin.
TEST(BallFriction, reduces_spin_by_its_torque) {
    World world = make_world({.gravity = {}});
    const BodyId body = ball_body(world, {0, 3, 4});
    const double inertia = state_of(world, body).inertia.z.z;
    join_to_world(world, body, BallJoint{.friction_torque = 2 * inertia});
    run(world, 1);
    EXPECT_TRUE(near(state_of(world, body).angular_velocity, Vec3{0, 1.8, 2.4}, 0.01));
    run(world, 2);
    EXPECT_LT(length(state_of(world, body).angular_velocity), 1e-4);
}

TEST(Drive, maximum_of_a_spring_is_saved) {
    World world = make_world();
    const JointId joint = join_to_world(world, ball_body(world),
                                        HingeJoint{.spring = {1, 1}, .spring_max_torque = 7});
    World loaded = must(load(save(world)));
    EXPECT_EQ(std::get<HingeJoint>(must(loaded.joint(joint)).def.kind).spring_max_torque, 7);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    loaded.set_joint(joint, HingeJoint{.spring = {1, 1}}).expect();
    EXPECT_NE(state_hash(loaded), state_hash(world));
    EXPECT_FALSE(world.set_joint(joint, HingeJoint{.spring_max_torque = -1}).ok());
}

TEST(Drive, continues_identically_after_load) {
    World world = make_world();
    const BodyId body = ball_body(world, {1, 2, 3});
    join_to_world(world, body,
                  BallJoint{.drive = {.spring = {1, 0.2}, .target = from_axis_angle({0, 0, 1}, 1)},
                            .friction_torque = 5});
    run(world, 1);
    World loaded = must(load(save(world)));
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    run(world, 1);
    run(loaded, 1);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
}

}  // namespace
}  // namespace jostle::test
