// SPDX-License-Identifier: MIT
//
// Limits of rotations at any angle up to half a turn, in both joint solvers.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/joint_fixture.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr JointSolver solvers[] = {JointSolver::direct, JointSolver::iterative};
constexpr JointLimit ranges[] = {{true, 0, pi},   {true, -pi, pi}, {true, -3.14, 3.14},
                                 {true, -pi, 0},  {true, 2, pi},   {true, -pi, -3},
                                 {true, -3, 3.1}, {true, -1, 1}};

JointId with_solver(World& world, JointSolver solver, JointDef def) {
    def.solver = solver;
    return must(world.create_joint(def));
}

// The arm of a hinge about z at an angle, 1 m from the hinge.
BodyId arm_at(World& world, double angle) {
    const SinCos at = sin_cos(angle);
    return block(world, {.geometry = Box{{1, 0.1, 0.1}},
                         .position = {at.cos, at.sin, 0},
                         .rotation = from_axis_angle({0, 0, 1}, angle)});
}

// Drives the arm to its upper limit, back to the lower one, and to the upper one again.
void drive_between_limits(JointSolver solver, const JointLimit& range, double speed) {
    World world = make_world({.gravity = {}});
    const double middle = 0.5 * (range.lower + range.upper);
    const BodyId arm = arm_at(world, middle);
    HingeJoint hinge{.limit = range, .motor = {true, speed, 1000 * speed}};
    const JointId joint =
        with_solver(world, solver, {.body_b = arm, .frame_b = {{-1, 0, 0}, {}}, .kind = hinge});
    double fastest = 0, gap = 0;
    for (int way = 0; way < 3; way++) {
        hinge.motor.speed = way % 2 == 0 ? speed : -speed;
        must(world.set_joint(joint, hinge));
        const int steps = 60 + static_cast<int>(60 * (range.upper - range.lower) / speed);
        for (int k = 0; k < steps; k++) {
            must(world.step(1.0 / 60));
            fastest = std::max(fastest, length(state_of(world, arm).angular_velocity));
            gap = std::max(gap, must(world.joint(joint)).separation);
        }
        EXPECT_NEAR(must(world.joint(joint)).angle, way % 2 == 0 ? range.upper : range.lower, 1e-3)
            << way;
        EXPECT_LT(length(state_of(world, arm).angular_velocity), 1e-3) << way;
    }
    EXPECT_LT(fastest, 1.01 * speed);  // the iterative solver leaves a limit with a bounce
    EXPECT_LT(gap, 0.01);
}

TEST(JointLimits, hinge_motor_stops_at_any_limit_and_leaves_it) {
    for (const JointSolver solver : solvers)
        for (const JointLimit& range : ranges)
            for (const double speed : {0.5, 5.0, 30.0}) {
                SCOPED_TRACE(testing::Message() << static_cast<int>(solver) << " " << range.lower
                                                << ".." << range.upper << " at " << speed);
                drive_between_limits(solver, range, speed);
            }
}

// A lid of 2 m is thrown open at 6 rad/s against a stop at half a turn and falls onto it.
TEST(JointLimits, lid_opens_half_a_turn) {
    for (const JointSolver solver : solvers)
        for (const double hz : {30.0, 60.0, 240.0}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(solver) << " at " << hz << " Hz");
            World world = make_world();
            const BodyId lid = block(world, {.geometry = Box{{1, 0.1, 0.1}},
                                             .position = {1, 0, 0},
                                             .velocity = {0, 6, 0},
                                             .spin = {0, 0, 6}});
            const JointId joint = with_solver(world, solver,
                                              {.body_b = lid,
                                               .frame_b = {{-1, 0, 0}, {}},
                                               .kind = HingeJoint{.limit = {true, 0, pi}}});
            double fastest = 0, gap = 0;
            for (int k = 0; k < 10 * hz; k++) {
                must(world.step(1 / hz));
                fastest = std::max(fastest, length(state_of(world, lid).angular_velocity));
                gap = std::max(gap, must(world.joint(joint)).separation);
            }
            EXPECT_LT(fastest, 6.01);
            EXPECT_LT(gap, 5e-3);
            EXPECT_NEAR(position_of(world, lid).x, -1, 1e-3);
            EXPECT_NEAR(must(world.joint(joint)).angle, pi, 2e-3);
        }
}

// A spring whose rest angle is across the limit at half a turn pulls the long way round.
TEST(JointLimits, spring_does_not_pull_through_a_limit) {
    for (const JointSolver solver : solvers) {
        World world = make_world({.gravity = {}});
        const BodyId arm = arm_at(world, -2.9);
        const JointId joint =
            with_solver(world, solver,
                        {.body_b = arm,
                         .frame_b = {{-1, 0, 0}, {}},
                         .kind = HingeJoint{
                             .limit = {true, -pi, pi}, .spring = {0.5, 1}, .spring_angle = 2.9}});
        run(world, 6);
        EXPECT_NEAR(must(world.joint(joint)).angle, 2.9, 0.01) << static_cast<int>(solver);
    }
}

// Without limits the shorter way is right, whichever side of half a turn the arm is on.
TEST(JointLimits, spring_without_limits_pulls_the_shorter_way) {
    for (const JointSolver solver : solvers) {
        World world = make_world({.gravity = {}});
        const BodyId arm = arm_at(world, -2.9);
        const JointId joint =
            with_solver(world, solver,
                        {.body_b = arm,
                         .frame_b = {{-1, 0, 0}, {}},
                         .kind = HingeJoint{.spring = {0.5, 1}, .spring_angle = 2.9}});
        double least = pi;
        for (int k = 0; k < 360; k++) {
            must(world.step(1.0 / 60));
            least = std::min(least, std::abs(must(world.joint(joint)).angle));
        }
        EXPECT_GT(least, 2.8) << static_cast<int>(solver);
        EXPECT_NEAR(must(world.joint(joint)).angle, 2.9, 0.01) << static_cast<int>(solver);
    }
}

// The same for the twist of a cone, the rotations of a six-dof and the steering of a wheel: a spin
// of 3 rad/s stops at the limit.
TEST(JointLimits, other_kinds_stop_at_half_a_turn) {
    for (const JointSolver solver : solvers)
        for (const JointLimit& range : ranges)
            for (const double spin : {-3.0, 3.0})
                for (int kind = 0; kind < 4; kind++) {
                    SCOPED_TRACE(testing::Message()
                                 << static_cast<int>(solver) << " " << range.lower << ".."
                                 << range.upper << " kind " << kind << " spin " << spin);
                    const Vec3 axes[] = {{1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
                    const Vec3 axis = axes[kind];
                    World world = make_world({.gravity = {}});
                    const double middle = 0.5 * (range.lower + range.upper);
                    const BodyId body = block(world, {.geometry = Box{{0.3, 0.2, 0.1}},
                                                      .rotation = from_axis_angle(axis, middle),
                                                      .spin = axis * spin});
                    SixDofAxes six;
                    (kind == 1 ? six.rotation_z : six.rotation_x) = {.free = true, .limit = range};
                    const JointKind kinds[] = {
                        ConeTwistJoint{.swing = 0.5, .twist = range}, SixDofJoint{six},
                        SixDofJoint{six},
                        WheelJoint{.free_steering = true, .steering_limit = range}};
                    with_solver(world, solver, {.body_b = body, .kind = kinds[kind]});
                    run(world, 4);
                    // The quaternion's sign does not matter: half a turn is -half a turn.
                    const double stop = spin > 0 ? range.upper : range.lower;
                    const Quat off = state_of(world, body).pose.rotation *
                                     conjugate(from_axis_angle(axis, stop));
                    EXPECT_LT(2 * length(Vec3{off.x, off.y, off.z}), 2e-3);
                    EXPECT_LT(length(state_of(world, body).angular_velocity), 1e-3);
                }
}

}  // namespace
}  // namespace jostle::test
