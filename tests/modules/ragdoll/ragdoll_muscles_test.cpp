// SPDX-License-Identifier: MIT
//
// Muscles, compared with closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "tests/modules/ragdoll/figures.h"

namespace jostle::modules {
namespace {

using namespace physics;

// A horizontal arm sags by m g l / k. The stiffness of the spring is the square of its frequency
// times the inertia about the joint.
TEST(RagdollMuscles, held_arm_sags_by_weight_over_stiffness) {
    for (const bool hinge : {false, true})
        for (const double hertz : {4.0, 8.0, 16.0}) {
            Stage stage;
            const JointKind joint = hinge ? JointKind(HingeJoint{}) : JointKind(BallJoint{});
            const RagdollId id = stage.add(arm(joint, {.hertz = hertz}));
            stage.ragdolls->set_mode(stage.world, id, RagdollMode::powered).expect();
            for (int k = 0; k < 300; k++) stage.step();
            const double mass = 8, inertia = mass / 12 * (0.4 * 0.4 + 0.1 * 0.1) + mass * 0.2 * 0.2;
            const double stiffness = inertia * (2 * pi * hertz) * (2 * pi * hertz);
            double sag = 0;
            for (int k = 0; k < 50; k++) sag = mass * 9.81 * 0.2 * std::cos(sag) / stiffness;
            EXPECT_NEAR(-stage.angle(id, 1), sag, 0.01 * sag) << hertz << " Hz, hinge " << hinge;
        }
}

// The torque is limited: an arm that is too heavy falls.
TEST(RagdollMuscles, muscle_yields_above_its_max_torque) {
    for (const JointKind& joint : {JointKind(BallJoint{}), JointKind(HingeJoint{})})
        for (const double share : {0.9, 1.1}) {
            Stage stage;
            const double weight = 8 * 9.81 * 0.2;
            const RagdollId id = stage.add(arm(joint, {.hertz = 20, .max_torque = share * weight}));
            stage.ragdolls->set_mode(stage.world, id, RagdollMode::powered).expect();
            for (int k = 0; k < 60; k++) stage.step();
            if (share < 1)
                EXPECT_LT(stage.angle(id, 1), -0.5) << kind_name(joint);
            else
                EXPECT_GT(stage.angle(id, 1), -0.05) << kind_name(joint);
        }
}

// A pose that oscillates by 0.5 rad at 1 Hz is followed in amplitude and phase, by hinges and ball
// joints.
TEST(RagdollMuscles, follows_a_1_hz_pose) {
    for (const bool hinge : {false, true})
        for (const Muscle& muscle : {Muscle{}, Muscle{.hertz = 20, .max_torque = 1e6}}) {
            Stage stage({.gravity = {}});
            const JointKind joint = hinge ? JointKind(HingeJoint{}) : JointKind(BallJoint{});
            const RagdollId id = stage.add(arm(joint, muscle));
            stage.ragdolls->set_mode(stage.world, id, RagdollMode::powered).expect();
            std::complex<double> sum = 0;
            for (int k = 1; k <= 300; k++) {
                const double t = k / 60.0;
                RagdollPose pose{
                    .rotations = {{}, from_axis_angle({0, 0, 1}, 0.5 * std::sin(2 * pi * t))}};
                stage.ragdolls->set_pose(id, pose).expect();
                stage.step();
                if (k > 180) sum += stage.angle(id, 1) * std::polar(1.0, -2 * pi * t);
            }
            // The mean of x e^(-i w t) is a / 2i for a sine of amplitude a without lag.
            const std::complex<double> ratio = sum / 120.0 * std::complex<double>(0, 2) / 0.5;
            RecordProperty(hinge ? "hinge_amplitude" : "ball_amplitude",
                           std::to_string(std::abs(ratio)));
            RecordProperty(hinge ? "hinge_phase_rad" : "ball_phase_rad",
                           std::to_string(std::arg(ratio)));
            EXPECT_LT(std::abs(ratio - 1.0), 0.012) << muscle.hertz << " Hz, hinge " << hinge;
        }
}

TEST(RagdollMuscles, half_strength_halves_the_stiffness) {
    double sag[2] = {};
    for (const int half : {0, 1}) {
        Stage stage;
        const RagdollId id = stage.add(arm(HingeJoint{}, {.hertz = 16}));
        stage.ragdolls->set_mode(stage.world, id, RagdollMode::powered).expect();
        stage.ragdolls->set_strength(id, 1, half == 1 ? 0.5 : 1).expect();
        for (int k = 0; k < 300; k++) stage.step();
        sag[half] = stage.angle(id, 1);
    }
    EXPECT_NEAR(sag[1] / sag[0], 2, 0.02);
}

// Figures thrown at the floor at 10 m/s in 24 orientations, straight and at angles of 30 and 60
// degrees: the largest violation of joint limits and the largest separation of joints at any time.
TEST(RagdollMuscles, joint_limits_hold_under_impacts) {
    double worst = 0, gap = 0;
    for (int number = 0; number < 72; number++) {
        const int turn = number % 24;
        const SinCos slope = sin_cos(number / 24 * pi / 6), heading = sin_cos(0.7 * turn);
        Stage stage;
        stage.floor();
        const RagdollId id = stage.add(
            human_figure(), {.position = {0, 2.5, 0},
                             .rotation = from_axis_angle({1, 0.3 * turn, 0.7}, 1.0 * turn)});
        for (const BodyId body : *stage.ragdolls->bodies(id))
            stage.world
                .set_linear_velocity(
                    body, Vec3{slope.sin * heading.cos, -slope.cos, slope.sin * heading.sin} * 10)
                .expect();
        for (int k = 0; k < 120; k++) {
            stage.step();
            for (const JointId joint : *stage.ragdolls->joints(id)) {
                if (is_null(joint)) continue;
                const JointState state = *stage.world.joint(joint);
                gap = std::max(gap, state.separation);
                const auto beyond = [&](double angle, const JointLimit& limit) {
                    worst = std::max({worst, angle - limit.upper, limit.lower - angle});
                };
                if (const auto* hinge = std::get_if<HingeJoint>(&state.def.kind))
                    beyond(state.angle, hinge->limit);
                if (const auto* cone = std::get_if<ConeTwistJoint>(&state.def.kind)) {
                    beyond(state.angle, cone->twist);
                    worst = std::max(worst, state.swing - cone->swing);
                }
            }
        }
    }
    RecordProperty("degrees_beyond", std::to_string(worst * 180 / pi));
    RecordProperty("gap_mm", std::to_string(gap * 1000));
    EXPECT_LT(worst * 180 / pi, 10);
    EXPECT_LT(gap, 0.005);
}

}  // namespace
}  // namespace jostle::modules
