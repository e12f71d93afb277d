// SPDX-License-Identifier: MIT
//
// Gears, racks and pulleys against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/joint_fixture.h"
#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

// A wheel on a hinge about the world's z.
BodyId wheel_at(World& world, Vec3 at, const HingeJoint& hinge = {}) {
    const BodyId wheel = block(world, {.geometry = Cylinder{0.4, 0.1}, .position = at});
    join(world, {}, wheel, hinge, {at, {}});
    return wheel;
}

// The turn about z, counted over whole turns: one step is less than half a turn.
struct Counted {
    double turn = 0, last = 0;
    void see(const World& world, BodyId body) {
        const Vec3 x = rotate(state_of(world, body).pose.rotation, {1, 0, 0});
        const double now = std::atan2(x.y, x.x);
        turn += std::remainder(now - last, 2 * pi);
        last = now;
    }
};

// A minute at 6 rad/s against a load: 57 turns, and no drift.
TEST(Gear, holds_its_ratio_for_a_minute) {
    World world = make_world({.gravity = {}});
    const BodyId small = wheel_at(world, {0, 0, 0}, {.motor = {true, 6, 1e5}});
    const BodyId large = wheel_at(world, {3, 0, 0}, {.motor = {true, 0, 20}});
    join(world, small, large, GearJoint{.ratio = 2.5});
    Counted a, b;
    double worst = 0;
    for (int i = 0; i < 3600; i++) {
        must(world.step(1.0 / 60));
        a.see(world, small);
        b.see(world, large);
        worst = std::max(worst, std::abs(a.turn + 2.5 * b.turn));
    }
    EXPECT_NEAR(a.turn, 6 * 60, 2);
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(std::abs(a.turn + 2.5 * b.turn), 1e-3);
}

// Torque: 1 N m on the first wheel acts as 1 N m against I_a + I_b / ratio^2.
TEST(Gear, accelerates_by_the_combined_inertia) {
    World world = make_world({.gravity = {}});
    const BodyId first = wheel_at(world, {0, 0, 0});
    const BodyId second = wheel_at(world, {3, 0, 0});
    join(world, first, second, GearJoint{.ratio = 2});
    const double inertia = state_of(world, first).inertia.z.z;
    for (int i = 0; i < 60; i++) {
        must(world.apply_torque(first, {0, 0, inertia}));
        must(world.step(1.0 / 60));
    }
    EXPECT_NEAR(state_of(world, first).angular_velocity.z, 1 / (1 + 0.25), 2e-3);
    EXPECT_NEAR(state_of(world, second).angular_velocity.z, -0.5 / (1 + 0.25), 2e-3);
}

// Fast: more than half a turn in each step.
TEST(Gear, holds_its_ratio_at_200_rad_s) {
    World world = make_world({.gravity = {}});
    const BodyId first = wheel_at(world, {0, 0, 0}, {.motor = {true, 200, 1e6}});
    const BodyId second = wheel_at(world, {3, 0, 0});
    join(world, first, second, GearJoint{.ratio = -1});
    run(world, 10);
    EXPECT_NEAR(state_of(world, first).angular_velocity.z, 200, 0.1);
    EXPECT_NEAR(state_of(world, second).angular_velocity.z, 200, 0.1);
    const double turn =
        2 * std::acos(std::min(
                1.0, std::abs(dot(rotate(state_of(world, first).pose.rotation, {1, 0, 0}),
                                  rotate(state_of(world, second).pose.rotation, {1, 0, 0})))));
    EXPECT_LT(turn, 0.02) << "equal wheels that turn alike point alike";
}

// Both wheels on a frame that tumbles: the frame carries them, so they turn against it alone, and
// what they do to each other it feels. Nothing outside pushes: the angular momentum stays.
TEST(Gear, rotates_relative_to_its_carrier) {
    World world = make_world({.gravity = {}});
    const BodyId frame = block(world, {.geometry = Box{{1.5, 0.2, 0.2}}, .spin = {0.5, 1, 2}});
    const auto wheel = [&](double x, const HingeJoint& hinge) {
        const BodyId body = block(
            world, {.geometry = Cylinder{0.4, 0.1}, .position = {x, 0, 1}, .spin = {0.5, 1, 2}});
        const JointId joint = join(world, frame, body, hinge, {{x, 0, 1}, {}});
        return std::pair(body, joint);
    };
    const auto [first, first_hinge] = wheel(-1, {.motor = {true, 3, 50}});
    const auto [second, second_hinge] = wheel(1, {});
    join(world, first, second, GearJoint{.ratio = 3});
    run(world, 1.0 / 60);
    const Vec3 before = world.summary().angular_momentum;
    double worst = 0, a = 0, b = 0, last_a = 0, last_b = 0;
    for (int i = 0; i < 600; i++) {
        must(world.step(1.0 / 60));
        const double now_a = must(world.joint(first_hinge)).angle,
                     now_b = must(world.joint(second_hinge)).angle;
        a += std::remainder(now_a - last_a, 2 * pi);
        b += std::remainder(now_b - last_b, 2 * pi);
        last_a = now_a, last_b = now_b;
        worst = std::max(worst, std::abs(a + 3 * b));
    }
    EXPECT_GT(std::abs(a), 10);
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(length(world.summary().angular_momentum - before), 0.01 * length(before));
}

// Bevel gears: one about z, the other about x.
TEST(Gear, supports_non_parallel_axes) {
    World world = make_world({.gravity = {}});
    const Quat to_x = from_axis_angle({0, 1, 0}, pi / 2);
    const BodyId first = wheel_at(world, {0, 0, 0}, {.motor = {true, 2, 1e5}});
    const BodyId second = block(world, {.geometry = Sphere{0.4}, .position = {3, 0, 0}});
    join(world, {}, second, HingeJoint{}, {{3, 0, 0}, to_x}, {{}, to_x});
    join(world, first, second, GearJoint{.ratio = 1}, {}, {{}, to_x});
    run(world, 3);
    EXPECT_NEAR(state_of(world, first).angular_velocity.z, 2, 1e-3);
    EXPECT_NEAR(state_of(world, second).angular_velocity.x, -2, 1e-3);
}

// A weight on the rack turns the pinion: a = g / (1 + I / (m r^2)).
TEST(Rack, falls_at_the_analytic_rate_with_the_pinion_inertia) {
    World world = make_world();
    const BodyId pinion = wheel_at(world, {0, 0, 0});
    const Quat down = from_axis_angle({1, 0, 0}, pi / 2);  // z to -y
    const BodyId rack = block(world, {.geometry = Box{{0.1, 0.5, 0.1}}, .position = {2, 0, 0}});
    join(world, {}, rack, SliderJoint{}, {{2, 0, 0}, down}, {{}, down});
    join(world, pinion, rack, RackJoint{.radius = 0.4}, {}, {{}, down});
    const double inertia = state_of(world, pinion).inertia.z.z, mass = state_of(world, rack).mass;
    const double a = 9.81 / (1 + inertia / (mass * 0.16));
    Counted turned;
    double worst = 0;
    for (int i = 0; i < 60; i++) {
        must(world.step(1.0 / 60));
        turned.see(world, pinion);
        worst = std::max(worst, std::abs(-position_of(world, rack).y - 0.4 * turned.turn));
    }
    EXPECT_NEAR(velocity_of(world, rack).y, -a, 0.01 * a);
    EXPECT_NEAR(state_of(world, pinion).angular_velocity.z, a / 0.4, 0.01 * a / 0.4);
    EXPECT_LT(worst, 1e-3);
}

// An eccentric pinion drives a rack along x or a second eccentric wheel.
struct Eccentric {
    World world;
    BodyId first, second;
    Transform axle{{-0.3, 0, 0}, {}};

    explicit Eccentric(bool gear) : world(make_world({.substeps = 4})) {
        first = wheel({0, 0, 0});
        const Quat along = from_axis_angle({0, 1, 0}, pi / 2);
        if (gear) {
            second = wheel({3, 0, 0});
            join(world, first, second, GearJoint{.ratio = 2.5}, axle, axle);
            return;
        }
        second = block(world, {.geometry = Box{{0.5, 0.1, 0.1}}, .position = {2, 0, 0}});
        join(world, {}, second, SliderJoint{}, {{2, 0, 0}, along}, {{}, along});
        join(world, first, second, RackJoint{.radius = 0.2}, axle, {{}, along});
    }
    BodyId wheel(Vec3 at) {
        const BodyId body =
            block(world, {.geometry = Box{{0.4, 0.1, 0.1}}, .position = at + Vec3{0.3, 0, 0}});
        join(world, {}, body, HingeJoint{}, {at, {}}, axle);
        return body;
    }
    double energy() const {
        const WorldSummary sum = world.summary();
        return sum.kinetic_energy + sum.potential_energy;
    }
};

// 60 Hz with 4 sub-steps: 1e-4 of the largest kinetic energy, and the ratio exactly.
TEST(GearJoints, eccentric_wheels_keep_their_energy_and_ratio) {
    for (const bool gear : {false, true}) {
        SCOPED_TRACE(gear ? "gear" : "rack");
        Eccentric it(gear);
        Counted turn, other;
        const double before = it.energy();
        double worst = 0, kinetic = 0, off = 0;
        for (int i = 0; i < 600; i++) {
            must(it.world.step(1.0 / 60));
            turn.see(it.world, it.first);
            other.see(it.world, it.second);
            kinetic = std::max(kinetic, it.world.summary().kinetic_energy);
            worst = std::max(worst, std::abs(it.energy() - before));
            off = std::max(
                off, gear ? std::abs(turn.turn + 2.5 * other.turn)
                          : std::abs(position_of(it.world, it.second).x - 2 - 0.2 * turn.turn));
        }
        EXPECT_LT(worst, 1e-4 * kinetic);
        EXPECT_LT(off, 1e-7);
    }
}

struct Atwood {
    World world = make_world();
    BodyId left, right;
    JointId rope;

    Atwood(double m1, double m2, const PulleyJoint& kind) {
        left = block(world, {.geometry = Sphere{0.2}, .position = {-1, 0, 0}});
        right = block(world, {.geometry = Sphere{0.2}, .position = {1, 0, 0}});
        must(world.set_mass(left, m1));
        must(world.set_mass(right, m2));
        rope = join(world, left, right, kind);
    }
};

// Atwood's machine: a = g (m1 - m2) / (m1 + m2), rope tension 2 m1 m2 g / (m1 + m2).
TEST(Pulley, matches_the_atwood_machine) {
    Atwood it(3, 2, {.point_a = {-1, 5, 0}, .point_b = {1, 5, 0}, .length = 10});
    run(it.world, 1);
    EXPECT_NEAR(velocity_of(it.world, it.left).y, -9.81 / 5, 0.01);
    EXPECT_NEAR(velocity_of(it.world, it.right).y, 9.81 / 5, 0.01);
    EXPECT_NEAR(position_of(it.world, it.left).y, -9.81 / 10, 0.03);
    EXPECT_NEAR(must(it.world.joint(it.rope)).travel, 10, 1e-3);
    EXPECT_NEAR(must(it.world.joint(it.rope)).force.y, 2.4 * 9.81, 0.05);
}

double energy_of(const World& world) {
    const WorldSummary sum = world.summary();
    return sum.kinetic_energy + sum.potential_energy;
}

// For 10 s, in which the weights move by 98 m: the parabola, and the energy.
TEST(Pulley, atwood_machine_keeps_its_energy) {
    Atwood it(3, 2, {.point_a = {-1, 200, 0}, .point_b = {1, 200, 0}, .length = 400});
    const double before = energy_of(it.world);
    run(it.world, 10);
    EXPECT_NEAR(position_of(it.world, it.left).y, -0.5 * 9.81 / 5 * 100, 1e-6);
    EXPECT_NEAR(must(it.world.joint(it.rope)).travel, 400, 1e-9);
    EXPECT_NEAR(energy_of(it.world), before, 1e-6);
}

// One weight swings: the other one's tension varies, and the machine has no closed form.
TEST(Pulley, error_falls_with_the_square_of_the_step) {
    const auto swing = [](double hz, int substeps) {
        World world = make_world({.substeps = substeps});
        const BodyId left = block(world, {.geometry = Sphere{0.05}, .position = {-1, -1, 0}});
        const BodyId right = block(
            world, {.geometry = Sphere{0.05}, .position = {1 + std::sin(1.0), -std::cos(1.0), 0}});
        must(world.set_mass(left, 3));
        must(world.set_mass(right, 1));
        join(world, left, right, PulleyJoint{{-1, 0, 0}, {1, 0, 0}, 2});
        for (int i = 0; i < 2 * hz; i++) must(world.step(1 / hz));
        return position_of(world, right);
    };
    const Vec3 exact = swing(480, 8);
    const double coarse = length(swing(60, 4) - exact), fine = length(swing(120, 4) - exact);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_GT(coarse, 3.5 * fine);
}

// A tackle of two: 2 kg hold 4 kg.
TEST(Pulley, ratio_acts_as_a_block_and_tackle) {
    Atwood it(2, 4, {.point_a = {-1, 5, 0}, .point_b = {1, 5, 0}, .length = 15, .ratio = 2});
    run(it.world, 5);
    EXPECT_NEAR(position_of(it.world, it.left).y, 0, 2e-3);
    EXPECT_NEAR(position_of(it.world, it.right).y, 0, 2e-3);
}

// A loose rope does nothing until it is tight.
TEST(Pulley, only_pulls) {
    Atwood it(2, 2, {.point_a = {-1, 5, 0}, .point_b = {1, 5, 0}, .length = 11});
    run(it.world, 0.2);
    EXPECT_NEAR(velocity_of(it.world, it.left).y, -9.81 * 0.2, 1e-3);
    EXPECT_EQ(length(must(it.world.joint(it.rope)).force), 0);
    run(it.world, 3);
    EXPECT_LT(must(it.world.joint(it.rope)).travel, 11 + 2e-3);
    EXPECT_NEAR(velocity_of(it.world, it.left).y, 0, 0.05);
}

TEST(Pulley, breaks_at_its_force) {
    Atwood it(30, 20, {.point_a = {-1, 5, 0}, .point_b = {1, 5, 0}, .length = 10});
    must(it.world.destroy_joint(it.rope));
    must(it.world.create_joint({.body_a = it.left,
                                .body_b = it.right,
                                .kind = PulleyJoint{{-1, 5, 0}, {1, 5, 0}, 10},
                                .break_force = 200}));  // it bears 235 N
    run(it.world, 0.1);
    EXPECT_TRUE(it.world.joints().empty());
}

TEST(GearJoints, continue_identically_after_load_for_any_thread_count) {
    const auto make = [](int threads) {
        World world = make_world({.threads = threads});
        const BodyId pinion = wheel_at(world, {0, 0, 0}, {.motor = {true, 3, 500}});
        const BodyId wheel = wheel_at(world, {3, 0, 0});
        const BodyId rack = block(world, {.geometry = Box{{0.1, 0.5, 0.1}}, .position = {6, 0, 0}});
        const BodyId weight = block(world, {.geometry = Sphere{0.3}, .position = {8, 0, 0}});
        join(world, {}, rack, SliderJoint{.limit = {true, -20, 20}}, {{6, 0, 0}, {}});
        join(world, pinion, wheel, GearJoint{.ratio = 1.7});
        join(world, wheel, rack, RackJoint{.radius = 0.4});
        join(world, rack, weight, PulleyJoint{{6, 5, 0}, {8, 5, 0}, 11, 1});
        run(world, 2);
        return world;
    };
    World world = make(1), other = make(4);
    EXPECT_EQ(state_hash(world), state_hash(other));
    World loaded = must(load(save(world)));
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    run(world, 2);
    run(loaded, 2);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
}

}  // namespace
}  // namespace jostle::test
