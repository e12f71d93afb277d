// SPDX-License-Identifier: MIT
//
// Muscles, compared with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "tests/modules/ragdoll/figures.h"
#include "tests/support/random.h"

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

struct Violation {
    double angle = 0, gap = 0;  // rad, m
};
// Throws a figure of the stage and returns the largest violation of its limits and the largest
// separation of its joints in two seconds.
Violation throw_figure(Stage& stage, const RagdollDef& figure, const Transform& origin, Vec3 v) {
    const RagdollId id = stage.add(figure, origin);
    for (const BodyId body : *stage.ragdolls->bodies(id))
        stage.world.set_linear_velocity(body, v).expect();
    Violation worst;
    for (int k = 0; k < 120; k++) {
        stage.step();
        for (const JointId joint : *stage.ragdolls->joints(id)) {
            if (is_null(joint)) continue;
            const JointState state = *stage.world.joint(joint);
            worst.gap = std::max(worst.gap, state.separation);
            const auto beyond = [&](double angle, const JointLimit& limit) {
                worst.angle = std::max({worst.angle, angle - limit.upper, limit.lower - angle});
            };
            if (const auto* hinge = std::get_if<HingeJoint>(&state.def.kind))
                beyond(state.angle, hinge->limit);
            if (const auto* cone = std::get_if<ConeTwistJoint>(&state.def.kind)) {
                beyond(state.angle, cone->twist);
                worst.angle = std::max(worst.angle, state.swing - cone->swing);
            }
        }
    }
    return worst;
}

// Figures thrown at the floor at 10 m/s in 24 orientations, straight and at angles of 30 and 60
// degrees: the largest violation of joint limits and the largest separation of joints at any time.
TEST(RagdollMuscles, joint_limits_hold_under_impacts) {
    Violation worst;
    for (int number = 0; number < 72; number++) {
        const int turn = number % 24;
        const SinCos slope = sin_cos(number / 24 * pi / 6), heading = sin_cos(0.7 * turn);
        Stage stage;
        stage.floor();
        const Violation found = throw_figure(
            stage, human_figure(), {{0, 2.5, 0}, from_axis_angle({1, 0.3 * turn, 0.7}, 1.0 * turn)},
            Vec3{slope.sin * heading.cos, -slope.cos, slope.sin * heading.sin} * 10);
        worst = {std::max(worst.angle, found.angle), std::max(worst.gap, found.gap)};
    }
    RecordProperty("degrees_beyond", std::to_string(worst.angle * 180 / pi));
    RecordProperty("gap_mm", std::to_string(worst.gap * 1000));
    EXPECT_LT(worst.angle * 180 / pi, 1);
    EXPECT_LT(worst.gap, 0.005);
}

// Seeded directions at 3 to 15 m/s, figures of 1.8 m and 1 m, onto a floor, an edge and a wall.
TEST(RagdollMuscles, joint_limits_hold_for_throws_in_any_direction) {
    jostle::test::Random random(17);
    for (const double height : {1.8, 1.0})
        for (const char* const target : {"floor", "edge", "wall"})
            for (int number = 0; number < 8; number++) {
                SCOPED_TRACE(testing::Message() << height << " m, " << target << ' ' << number);
                Stage stage;
                stage.floor();
                const auto add_box = [&](Vec3 half, const Transform& pose) {
                    stage.world
                        .create_body({.type = BodyType::static_body, .pose = pose},
                                     {.geometry = Box{half}})
                        .value();
                };
                const Vec3 way = random.direction();
                const double speed = random.in(3, 15);
                const Quat rotation = random.rotation();
                Vec3 v = way * speed;
                v.y = -std::abs(v.y);
                Vec3 from{0, 4, 0};
                if (target == std::string("edge")) {
                    add_box({0.7, 0.7, 6}, {{0, 1, 0}, from_axis_angle({0, 0, 1}, pi / 4)});
                } else if (target == std::string("wall")) {
                    add_box({0.5, 6, 12}, {{3, 5, 0}, {}});
                    v = {std::abs(v.y), v.x * 0.5 - 1, v.z};
                    from = {0.6, 2.5, 0};
                }
                const Violation worst =
                    throw_figure(stage, human_figure(height), {from, rotation}, v);
                EXPECT_LT(worst.angle * 180 / pi, 1);
                EXPECT_LT(worst.gap, 0.005);
            }
}

}  // namespace
}  // namespace jostle::modules
