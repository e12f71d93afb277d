// SPDX-License-Identifier: MIT
//
// The rows that all joints are made of: hold two points together, hold directions together, limit
// or drive one angle or distance. Doubles throughout; velocities are read from and written to the
// floats that contacts work on.
#pragma once

#include <span>

#include "constraints/softness.h"
#include "state/joint_store.h"
#include "state/joint_work.h"
#include "state/solver_body.h"

namespace jostle::physics {

struct JointStep {
    double h = 0, inverse_h = 0;
    Softness rigid;      // of what the user did not make a spring
    bool relax = false;  // the pass without push
};

// Two bodies of a joint at this moment of the step.
class JointPair {
public:
    JointPair(JointWork& work, std::span<HotBody> bodies);
    void store(std::span<HotBody> bodies);  // writes the velocities back, and what changed

    Vec3 apart;         // from a's anchor to b's, m
    Vec3 arm_a, arm_b;  // of the anchors
    Quat frame_a, frame_b;
    Quat carrier;  // rotation of the body that the joint's impulses turn with
    Vec3 va, wa, vb, wb;

    Vec3 anchor_velocity() const { return (vb + cross(wb, arm_b)) - (va + cross(wa, arm_a)); }
    Vec3 spin() const { return wb - wa; }

    // On b at its anchor, against a.
    void push(Vec3 impulse);
    void turn(Vec3 impulse);

    // What an impulse at the anchors, or a turn, does to the relative motion.
    Mat3 point_matrix() const;
    Mat3 turn_matrix() const { return work_.a.inverse_inertia + work_.b.inverse_inertia; }
    double inverse_mass_along(Vec3 unit) const;  // of a pull along a line through both anchors
    double inverse_spin_about(Vec3 axis) const { return dot(axis, turn_matrix() * axis); }

private:
    JointWork& work_;
    Vec3 start_va_, start_wa_, start_vb_, start_wb_;
};

// The point row: the anchors stay together. `impulse` accumulates.
void hold_points(JointPair& pair, const JointStep& step, const Softness& softness, Vec3& impulse);

// All three turns: `error` is the rotation vector from where b should be to where it is.
void hold_turns(JointPair& pair, const JointStep& step, const Softness& softness, Vec3 error,
                Vec3& impulse);

// The two turns across an axis.
void hold_axis(JointPair& pair, const JointStep& step, const Softness& softness, Vec3 axis,
               Vec3 error, Vec3& impulse);

// One degree of freedom: an angle about an axis, or a length along a line.
struct Row {
    Vec3 direction;
    bool angular = true;
    double inverse_mass = 0;
};
Row angle_row(const JointPair& pair, Vec3 axis);
Row length_row(const JointPair& pair, Vec3 line);

// `room`: how much there is left before the limit; negative: beyond it. The row's direction is that
// in which the impulse may push (>= 0).
void limit_row(JointPair& pair, const JointStep& step, const Row& row, double room,
               double& impulse);
// Pulls the row's value `error` to zero.
void spring_row(JointPair& pair, const Row& row, const Softness& softness, double error,
                double& impulse);
// Drives the row's speed to the target with at most `most` per sub-step.
void motor_row(JointPair& pair, const Row& row, double speed, double most, double& impulse);

// Applies what accumulated in the step before.
void apply_row(JointPair& pair, const Row& row, double impulse);

}  // namespace jostle::physics
