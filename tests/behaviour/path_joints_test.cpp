// SPDX-License-Identifier: MIT
//
// Beads on wires against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId bead_at(World& world, Vec3 at) {
    return add(world, {.geometry = Sphere{0.05}, .position = at, .sleep_allowed = false});
}

JointId wire(World& world, BodyId bead, const PathJoint& path) {
    return must(world.create_joint({.body_b = bead, .kind = path}));
}

// Seconds of a full swing, from the times at which the bead passes x = 0 to the right.
double swing_period(World& world, BodyId bead, double seconds) {
    double last = position_of(world, bead).x, first = -1, latest = -1;
    int times = 0;
    for (int i = 1; i <= seconds * 60; i++) {
        must(world.step(1.0 / 60));
        const double x = position_of(world, bead).x;
        if (last < 0 && x >= 0) {
            latest = (i - x / (x - last)) / 60;
            if (first < 0)
                first = latest;
            else
                times++;
        }
        last = x;
    }
    return times > 0 ? (latest - first) / times : 0;
}

PathJoint circle(double radius) {
    PathJoint path{.points = {}, .closed = true};
    for (int k = 0; k < 64; k++) {
        const double angle = 2 * pi * k / 64;
        path.points.push_back({radius * std::sin(angle), -radius * std::cos(angle), 0});
    }
    return path;
}

// On a circle a bead swings like a pendulum: 2 pi sqrt(r / g) (1 + A^2 / 16) for a small swing A.
TEST(Path, bead_on_a_circle_moves_as_a_pendulum) {
    World world = make_world();
    const double amplitude = 0.3;
    const BodyId bead = bead_at(world, {std::sin(amplitude), -std::cos(amplitude), 0});
    const JointId joint = wire(world, bead, circle(1));
    const double period = swing_period(world, bead, 20);
    const double exact = 2 * pi * std::sqrt(1 / 9.81) * (1 + amplitude * amplitude / 16);
    EXPECT_NEAR(period, exact, 0.005 * exact);
    EXPECT_LT(must(world.joint(joint)).separation, 1e-4);
}

// The cycloid is the curve on which all swings take the same time: 4 pi sqrt(r / g).
TEST(Path, cycloid_is_isochronous) {
    const double r = 0.5;
    const auto on_cycloid = [&](double u) {  // u = 0 at the bottom
        return Vec3{r * (u + std::sin(u)), -r * (1 + std::cos(u)), 0};
    };
    PathJoint path{.points = {}};
    for (int k = -30; k <= 30; k++) path.points.push_back(on_cycloid(k * 0.1));
    for (const double start : {0.3, 1.2, 2.2}) {
        SCOPED_TRACE(start);
        World world = make_world();
        const BodyId bead = bead_at(world, on_cycloid(start));
        wire(world, bead, path);
        const double exact = 4 * pi * std::sqrt(r / 9.81);
        EXPECT_NEAR(swing_period(world, bead, 16), exact, 0.005 * exact);
    }
}

struct Looped {
    Vec3 end;           // after 2 s
    double energy = 0;  // J: largest change in 10 s
};
// 1 kg on a circle of 1 m, started at an angle with a speed of 8 m/s or at rest.
Looped swing_on_circle(double start, double speed, double hz) {
    World world = make_world({.substeps = 4});
    const BodyId bead = bead_at(world, {std::sin(start), -std::cos(start), 0});
    must(world.set_mass(bead, 1));
    must(world.set_velocity(bead, {speed, 0, 0}, {}));
    wire(world, bead, circle(1));
    Looped found;
    const auto energy = [&] {
        const WorldSummary sum = world.summary();
        return sum.kinetic_energy + sum.potential_energy;
    };
    const double before = energy();
    for (int i = 1; i <= 10 * hz; i++) {
        must(world.step(1 / hz));
        found.energy = std::max(found.energy, std::abs(energy() - before));
        if (i == 2 * hz) found.end = position_of(world, bead);
    }
    return found;
}

TEST(Path, bead_keeps_its_energy_on_a_circle) {
    EXPECT_LT(swing_on_circle(1.5, 0, 60).energy, 1e-4 * 9.81 * (1 - std::cos(1.5)));
    EXPECT_LT(swing_on_circle(0, 8, 60).energy, 2e-4 * 32);
}

TEST(Path, error_falls_with_the_square_of_the_step) {
    const Vec3 exact = swing_on_circle(0, 8, 960).end;
    const double coarse = length(swing_on_circle(0, 8, 60).end - exact);
    const double fine = length(swing_on_circle(0, 8, 120).end - exact);
    EXPECT_LT(coarse, 5e-3);
    EXPECT_GT(coarse, 3.5 * fine);
}

// Down a wire without friction the speed is that of the height, sqrt(2 g h).
TEST(Path, conserves_energy) {
    World world = make_world();
    const BodyId bead = bead_at(world, {0, 2, 0});
    const JointId joint = wire(
        world, bead,
        {.points = {
             {-1, 4, 0}, {0, 2, 0}, {1, 1, 0.5}, {2, 0.6, 0}, {3, 0, -0.5}, {4, 1, 0}, {5, 3, 0}}});
    double worst = 0, lowest = 9;
    for (int i = 0; i < 600; i++) {
        must(world.step(1.0 / 60));
        const Vec3 v = velocity_of(world, bead), p = position_of(world, bead);
        worst = std::max(worst, std::abs(0.5 * dot(v, v) + 9.81 * p.y - 9.81 * 2) / (9.81 * 2));
        lowest = std::min(lowest, p.y);
        EXPECT_LT(must(world.joint(joint)).separation, 3e-3);
    }
    EXPECT_LT(lowest, 0.1);
    EXPECT_LT(worst, 0.02);
}

TEST(Path, motor_and_limits_act_along_the_curve) {
    World world = make_world({.gravity = {}});
    const BodyId bead = bead_at(world, {0, -1, 0});
    PathJoint path = circle(1);
    path.motor = {true, 1, 1e6};
    const JointId joint = wire(world, bead, path);
    run(world, 10);
    EXPECT_NEAR(length(velocity_of(world, bead)), 1, 1e-3);
    EXPECT_NEAR(must(world.joint(joint)).travel, 10 - 2 * pi, 0.02);
    World open = make_world();
    const BodyId stopped = bead_at(open, {0, 0, 0});
    const JointId slope = wire(
        open, stopped,
        {.points = {{0, 0, 0}, {2, -1, 0}, {4, -2, 0}}, .smooth = false, .limit = {true, 0, 3}});
    run(open, 3);
    EXPECT_NEAR(must(open.joint(slope)).travel, 3, 2e-3);
    must(open.set_joint(slope,
                        PathJoint{.points = {{0, 0, 0}, {2, -1, 0}, {4, -2, 0}}, .smooth = false}));
    run(open, 3);
    EXPECT_NEAR(must(open.joint(slope)).travel, std::sqrt(20), 2e-3) << "the end of the wire";
}

// 1 Hz along the wire, however it bends.
TEST(Path, spring_acts_along_the_curve) {
    World world = make_world({.gravity = {}});
    const BodyId bead = bead_at(world, {std::sin(0.5), -std::cos(0.5), 0});
    PathJoint path = circle(1);
    path.spring = {1, 0};
    path.spring_travel = 1;
    const JointId joint = wire(world, bead, path);
    double last = -1;
    int passes = 0;
    for (int i = 0; i < 600; i++) {
        must(world.step(1.0 / 60));
        const double at = must(world.joint(joint)).travel - 1;
        if (last < 0 && at >= 0) passes++;
        last = at;
    }
    EXPECT_NEAR(passes, 10, 1);
}

TEST(Path, continues_identically_after_load_and_moves_with_its_body) {
    World world = make_world();
    const BodyId frame = add(world, {.geometry = Box{{1, 0.05, 1}},
                                     .position = {0, 3, 0},
                                     .spin = {0, 1, 0},
                                     .sleep_allowed = false});
    const BodyId bead = bead_at(world, {0, 2, 0});
    must(world.create_joint(
        {.body_a = frame, .body_b = bead, .frame_a = {{0, 0, 0}, {}}, .kind = circle(1)}));
    run(world, 1);
    World loaded = must(load(save(world)));
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    run(world, 1);
    run(loaded, 1);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    EXPECT_LT(world.summary().max_joint_error, 1e-3);
}

}  // namespace
}  // namespace jostle::test
