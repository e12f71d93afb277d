// SPDX-License-Identifier: MIT
//
// Joints against closed forms: periods, limits, motors, breaking forces.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/joint_fixture.h"
#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

// A rod of 1 m on a hinge, released level: the period of a physical pendulum at 90 degrees is
// 1.935750 s (4 K(k) / w0).
TEST(Joints, pendulum_has_the_exact_period) {
    World world = make_world();
    const BodyId rod =
        add(world,
            {.geometry = Box{{0.5, 0.05, 0.05}}, .position = {0.5, 0, 0}, .sleep_allowed = false});
    const JointId hinge = join(world, anchor(world), rod, HingeJoint{}, {}, {{-0.5, 0, 0}, {}});
    // The rod comes back to the level after whole periods.
    double last = 0, returned = 0, worst = 0;
    int times = 0;
    for (int i = 0; i < 60 * 10; i++) {
        must(world.step(1.0 / 60));
        const double w = state_of(world, rod).angular_velocity.z;
        if (last > 0 && w <= 0) {  // turning point on the starting side
            returned = (i + last / (last - w)) / 60.0;
            times++;
        }
        last = w;
        worst = std::max(worst, must(world.joint(hinge)).separation);
    }
    ASSERT_EQ(times, 5);
    EXPECT_NEAR(returned / times, 1.935750, 0.02);
    EXPECT_LT(worst, 1e-3);
}

TEST(Joints, hinge_holds_its_axis_and_limits) {
    World world = make_world();
    const BodyId door =
        add(world, {.geometry = Box{{0.5, 1, 0.05}}, .position = {0.5, 0, 0}, .spin = {0, 3, 0}});
    // The hinge's z axis stands along the world's y.
    const Quat upright = from_rotation_vector({-pi / 2, 0, 0});
    const JointId hinge = join(world, anchor(world), door, HingeJoint{.limit = {true, -0.5, 1.0}},
                               {{}, upright}, {{-0.5, 0, 0}, upright});
    double most = 0;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        most = std::max(most, must(world.joint(hinge)).angle);
        const Vec3 up = rotate(state_of(world, door).pose.rotation, {0, 1, 0});
        EXPECT_GT(up.y, std::cos(0.005));
    }
    EXPECT_NEAR(most, 1.0, 0.01);
}

// Without gravity: the speed rises as torque over inertia until the motor's own.
TEST(Joints, motor_accelerates_by_its_torque_up_to_its_speed) {
    World world = make_world({.gravity = {}});
    const BodyId rod =
        add(world,
            {.geometry = Box{{0.5, 0.05, 0.05}}, .position = {0.5, 0, 0}, .sleep_allowed = false});
    const BodyState s = state_of(world, rod);
    const double about_pivot = s.inertia.z.z + s.mass * 0.25;
    join(world, anchor(world), rod, HingeJoint{.motor = {true, 2, about_pivot}}, {},
         {{-0.5, 0, 0}, {}});
    run(world, 1);  // 1 rad/s^2
    EXPECT_NEAR(state_of(world, rod).angular_velocity.z, 1, 0.01);
    run(world, 2);
    EXPECT_NEAR(state_of(world, rod).angular_velocity.z, 2, 1e-3);
}

TEST(Joints, cone_twist_limits_swing_and_twist) {
    World world = make_world();
    const BodyId arm = add(world, {.geometry = Capsule{0.1, 0.4},
                                   .position = {0.5, 0, 0},
                                   .rotation = from_rotation_vector({0, 0, pi / 2}),
                                   .spin = {8, 0, 0}});
    // b's frame: x along the arm. The capsule stands along its own y.
    const Quat along = from_rotation_vector({0, 0, -pi / 2});
    const JointId shoulder =
        join(world, anchor(world), arm, ConeTwistJoint{.swing = 0.6, .twist = {true, -0.4, 0.7}},
             {}, {{0, 0.5, 0}, along});
    double swing = 0, twist = 0, apart = 0;
    for (int i = 0; i < 300; i++) {
        must(world.step(1.0 / 60));
        const JointState j = must(world.joint(shoulder));
        swing = std::max(swing, j.swing);
        twist = std::max(twist, j.angle);
        apart = std::max(apart, j.separation);
    }
    EXPECT_NEAR(swing, 0.6, 0.05) << "it hangs at the edge of its cone";
    EXPECT_LT(twist, 0.75);
    EXPECT_GT(twist, 0.6);
    EXPECT_LT(apart, 5e-3);
}

TEST(Joints, fixed_bodies_move_as_one) {
    World world = make_world({.gravity = {}});
    const BodyId a = add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                                 .velocity = {0, 1, 0},
                                 .spin = {0, 0, 2},
                                 .sleep_allowed = false});
    const BodyId b = add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                                 .position = {1, 0, 0},
                                 .velocity = {0, 3, 0},
                                 .spin = {0, 0, 2},
                                 .sleep_allowed = false});
    const Transform turned{{1, 0, 0}, {}};
    join(world, a, b, FixedJoint{}, turned, {});
    run(world, 5);
    const BodyState sa = state_of(world, a), sb = state_of(world, b);
    EXPECT_TRUE(near(apply_inverse(sa.pose, sb.pose.position), {1, 0, 0}, 2e-3));
    EXPECT_TRUE(near(sa.angular_velocity, {0, 0, 2}, 0.02)) << "about the common centre";
    EXPECT_TRUE(near(sa.linear_velocity + sb.linear_velocity, {0, 4, 0}, 1e-4)) << "momentum";
}

// A weight on a spring: sinks by g / w^2 and swings with its own frequency.
// Its inverse inertias about its length and across lie a millionfold apart: as far as the joints'
// floats can tell.
TEST(Joints, flagpole_of_30_m_by_2_cm_is_held_at_its_base) {
    for (const Vec3 turn : {Vec3{}, Vec3{0.3, 0.5, 0.7}, Vec3{0, 1, 1.2}}) {
        World world = make_world();
        const Quat way = from_rotation_vector(turn);
        const BodyId pole =
            must(world.create_body({.pose = {rotate(way, {15, 0, 0}), way}, .sleep_allowed = false},
                                   {.geometry = Box{{15, 0.01, 0.01}}}));
        join(world, anchor(world), pole, FixedJoint{}, {{}, way}, {{-15, 0, 0}, {}});
        run(world, 5);
        const Vec3 tip = apply(state_of(world, pole).pose, {15, 0, 0});
        EXPECT_LT(length(tip - rotate(way, {30, 0, 0})), 0.03) << turn.x;
    }
}

TEST(Joints, spring_oscillates_at_its_frequency) {
    World world = make_world();
    const BodyId weight =
        add(world, {.geometry = Sphere{0.2}, .position = {0, -1, 0}, .sleep_allowed = false});
    const double hertz = 1;
    join(world, anchor(world), weight,
         DistanceJoint{.min_length = 0, .max_length = 10, .spring = {hertz, 0}, .rest_length = 1},
         {}, {});
    const double w = 2 * pi * hertz, sag = 9.81 / (w * w);
    double lowest = 0;
    for (int i = 0; i < 31; i++) {
        must(world.step(1.0 / 60));
        lowest = std::min(lowest, position_of(world, weight).y);
    }
    EXPECT_NEAR(lowest, -1 - 2 * sag, 0.05 * sag) << "half a period down";
    run(world, 29.0 / 60);
    EXPECT_NEAR(position_of(world, weight).y, -1, 0.2 * sag) << "and back";
}

TEST(Joints, rope_can_be_slack_and_a_rod_cannot) {
    World world = make_world();
    const BodyId fixed = anchor(world);
    const BodyId on_rope = add(world, {.geometry = Sphere{0.1}, .position = {0, -0.5, 0}});
    const BodyId on_rod = add(world, {.geometry = Sphere{0.1}, .position = {1, 0, 0}});
    const JointId rope =
        join(world, fixed, on_rope, DistanceJoint{.min_length = 0, .max_length = 2}, {}, {});
    const JointId rod = join(world, fixed, on_rod, DistanceJoint{}, {}, {});
    double rod_error = 0, longest = 0;
    for (int i = 0; i < 240; i++) {
        must(world.step(1.0 / 60));
        if (i == 20) {
            const double t = 21.0 / 60;
            EXPECT_NEAR(position_of(world, on_rope).y, -0.5 - 0.5 * 9.81 * t * t, 5e-3) << "slack";
        }
        longest = std::max(longest, must(world.joint(rope)).separation);
        rod_error = std::max(rod_error, std::fabs(must(world.joint(rod)).separation - 1));
    }
    EXPECT_LT(longest, 2.02);
    EXPECT_NEAR(position_of(world, on_rope).y, -2, 0.02);
    EXPECT_LT(rod_error, 2e-3);
}

// A weight of 10 kg on a joint that bears 90 N hangs; on one that bears 110 N it stays; the event
// names the load.
// Bodies get their shapes, and with them their mass, after they were made: joined before that they
// are moved by nothing, and none of them can carry the joint's impulse.
TEST(Joints, massless_bodies_can_be_jointed_before_their_shapes_exist) {
    World world = make_world();
    const BodyId a = must(world.create_body({.pose = {{1, 0, 0}, {}}}));
    const BodyId b = must(world.create_body({.pose = {{2, 0, 0}, {}}}));
    const JointId held =
        join(world, anchor(world), a, FixedJoint{}, {{1, 0, 0}, {}}, {});  // fixed and massless
    const JointId both = join(world, a, b, HingeJoint{}, {{1, 0, 0}, {}}, {});
    run(world, 1);
    for (const JointId joint : {held, both}) {
        EXPECT_EQ(must(world.joint(joint)).force, Vec3{});
        EXPECT_EQ(must(world.joint(joint)).torque, Vec3{});
    }
    for (const BodyId body : {a, b})
        must(world.create_shape(body, {.geometry = Box{{0.4, 0.2, 0.2}}}));
    run(world, 3);  // they fell by 5 m
    EXPECT_TRUE(near(position_of(world, a), {1, 0, 0}, 2e-3)) << "held by the anchor";
    EXPECT_LT(must(world.joint(both)).separation, 2e-3);
}

TEST(Joints, break_above_their_force_and_report_it) {
    for (const double bears : {90.0, 110.0}) {
        World world = make_world();
        const BodyId weight = must(
            world.create_body({.pose = {{0, -1, 0}, {}}, .mass = 10}, {.geometry = Sphere{0.2}}));
        const JointId joint = must(world.create_joint({.body_a = anchor(world),
                                                       .body_b = weight,
                                                       .frame_b = {{0, 1, 0}, {}},
                                                       .break_force = bears}));
        int broke = 0;
        for (int i = 0; i < 60; i++) {
            must(world.step(1.0 / 60));
            for (const JointBreak& b : world.events().joints_broke) {
                broke++;
                EXPECT_EQ(b.joint, joint);
                EXPECT_GT(b.force, bears);
            }
        }
        EXPECT_EQ(broke, bears < 98.1 ? 1 : 0) << bears << " N";
        EXPECT_EQ(world.contains(joint), bears > 98.1);
        if (bears > 98.1) {
            EXPECT_NEAR(must(world.joint(joint)).force.y, 98.1, 1);
        } else {
            EXPECT_LT(position_of(world, weight).y, -2);
        }
    }
}

TEST(Joints, jointed_bodies_collide_only_if_enabled) {
    for (const bool collide : {false, true}) {
        World world = make_world({.gravity = {}});
        const BodyId a = add(world, {.sleep_allowed = false});
        const BodyId b = add(world, {.position = {0.9, 0, 0}, .sleep_allowed = false});
        must(world.create_joint({.body_a = a,
                                 .body_b = b,
                                 .kind = DistanceJoint{.min_length = 0, .max_length = 5},
                                 .collide_connected = collide}));
        run(world, 1);
        const double apart = position_of(world, b).x - position_of(world, a).x;
        if (collide)
            EXPECT_NEAR(apart, 1, 0.01);
        else
            EXPECT_NEAR(apart, 0.9, 1e-9);
    }
}

TEST(Joints, chain_of_twenty_stays_connected_and_sleeps) {
    World world = make_world();
    BodyId above = anchor(world);
    std::vector<JointId> joints;
    for (int i = 0; i < 20; i++) {
        const BodyId link = add(world, {.geometry = Capsule{0.05, 0.1},
                                        .position = {0.15 + 0.3 * i, 0, 0},
                                        .rotation = from_rotation_vector({0, 0, pi / 2})});
        joints.push_back(join(world, above, link, BallJoint{},
                              i == 0 ? Transform{} : Transform{{0, -0.15, 0}, {}},
                              {{0, 0.15, 0}, {}}));
        must(world.set_damping(link, 0.3, 0.3));
        above = link;
    }
    double worst = 0;
    for (int i = 0; i < 60 * 40; i++) {
        must(world.step(1.0 / 60));
        if (i % 4 == 0)
            for (const JointId j : joints) worst = std::max(worst, must(world.joint(j)).separation);
    }
    EXPECT_LT(worst, 0.05);
    EXPECT_NEAR(position_of(world, above).y, -19.5 * 0.3, 0.02);
    EXPECT_EQ(world.summary().awake_bodies, 0);
}

TEST(Joints, destroying_a_body_removes_its_joints_and_wakes_the_other) {
    World world = make_world();
    const BodyId fixed = anchor(world), weight = add(world, {.position = {0, -1, 0}});
    const JointId joint = join(world, fixed, weight, BallJoint{}, {}, {{0, 1, 0}, {}});
    run(world, 3);
    EXPECT_FALSE(state_of(world, weight).awake);
    must(world.destroy_body(fixed));
    EXPECT_FALSE(world.contains(joint));
    run(world, 1);
    EXPECT_LT(position_of(world, weight).y, -5);
}

// A disc of 1 kg that spins at 40 rad/s, its middle 0.5 m above a ball joint, leaning by 60
// degrees: it goes round at the rate at which gravity's torque turns its angular momentum.
TEST(Joints, heavy_top_precesses_at_every_rate) {
    const double l = 0.5, lean = pi / 3, spin = 40, radius = std::sqrt(0.2), half = 0.001;
    const double own = 0.1, across = 0.05 + half * half / 3 + l * l;
    const double sine = std::sin(lean), cosine = std::cos(lean);
    const double rate =
        (own * spin - std::sqrt(own * own * spin * spin - 4 * across * cosine * 9.81 * l)) /
        (2 * across * cosine);
    const Vec3 axis{sine, cosine, 0}, center = axis * l;
    const Vec3 w = Vec3{0, rate, 0} + axis * (spin - rate * cosine);
    for (const double hz : {60.0, 240.0}) {
        World world = make_world({.sleeping = false});
        const Quat turn = from_axis_angle({0, 0, 1}, -lean);
        const BodyId top = add(world, {.geometry = Cylinder{radius, half},
                                       .position = center,
                                       .rotation = turn,
                                       .velocity = cross(w, center),
                                       .spin = w,
                                       .density = 1 / (pi * radius * radius * 2 * half)});
        join(world, anchor(world, {0, -5, 0}), top, BallJoint{}, {{0, 5, 0}, {}}, {{0, -l, 0}, {}});
        double sum = 0;
        const int steps = static_cast<int>(5 * hz);
        for (int k = 1; k <= steps; k++) {
            must(world.step(1 / hz));
            const double at = rate * k / hz;
            const Vec3 there{l * sine * std::cos(at), l * cosine, -l * sine * std::sin(at)};
            sum += length_squared(state_of(world, top).center - there);
        }
        EXPECT_LT(std::sqrt(sum / steps) / l, hz > 100 ? 1e-3 : 4e-3) << hz;
    }
}

// A joint whose ends begin a metre apart pulls a ball of 1 kg at a point off its middle. However
// fine the steps, it leaves the ball no more than what it has at the speed at which joints pull.
TEST(Joints, initial_error_adds_no_more_energy_at_finer_steps) {
    for (const double hz : {60.0, 240.0, 1000.0}) {
        for (const int substeps : {8, 64}) {
            World world = make_world({.gravity = {}, .substeps = substeps, .sleeping = false});
            const BodyId ball = add(world, {.geometry = Sphere{0.1}, .density = 238.7});
            const JointId joint = join(world, anchor(world, {0, 5, 0}), ball, BallJoint{},
                                       {{1.5, -4.9, 0}, {}}, {{0.5, 0.1, 0}, {}});
            run(world, 1, hz);
            EXPECT_LT(world.summary().kinetic_energy, 10) << hz << " Hz, " << substeps;
            EXPECT_LT(must(world.joint(joint)).separation, 1e-3);
        }
    }
}

}  // namespace
}  // namespace jostle::test
