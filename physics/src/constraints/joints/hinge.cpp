// SPDX-License-Identifier: MIT
#include "constraints/joints/kinds.h"

namespace jostle::physics {

double hinge_angle(Quat frame_a, Quat frame_b) {
    const Mat3 a = to_matrix(frame_a), b = to_matrix(frame_b);
    return arc_tangent(dot(b.x, a.y), dot(b.x, a.x));
}

namespace {

Vec3 axis_of(const JointPair& pair) {
    return rotate(pair.frame_a, {0, 0, 1});
}

double along_axis(const Joint& joint) {
    return joint.lower - joint.upper + joint.spring + joint.motor;
}

}  // namespace

void warm_start_hinge(JointPair& pair, const HingeJoint&, Joint& joint) {
    pair.push(joint.point);
    pair.turn(joint.turn + axis_of(pair) * along_axis(joint));
}

void solve_hinge(JointPair& pair, const JointStep& step, const HingeJoint& kind, Joint& joint) {
    const Vec3 axis = axis_of(pair);
    const Row row = angle_row(pair, axis);
    const double angle = hinge_angle(pair.frame_a, pair.frame_b);
    // The weakest first: what must hold has the last word.
    if (kind.spring.hertz > 0)
        spring_row(pair, row, soft(kind.spring.hertz, kind.spring.damping_ratio, step.h),
                   angle - kind.spring_angle, joint.spring);
    else
        joint.spring = 0;
    if (kind.motor.enabled)
        motor_row(pair, row, kind.motor.speed, kind.motor.max_torque * step.h, joint.motor);
    else
        joint.motor = 0;
    if (kind.limit.enabled) {
        limit_row(pair, step, row, angle - kind.limit.lower, joint.lower);
        limit_row(pair, step, {-axis, true, row.inverse_mass}, kind.limit.upper - angle,
                  joint.upper);
    } else {
        joint.lower = joint.upper = 0;
    }
    const Vec3 axis_b = rotate(pair.frame_b, {0, 0, 1});
    hold_axis(pair, step, step.rigid, axis, cross(axis, axis_b), joint.turn);
    hold_points(pair, step, step.rigid, joint.point);
}

JointLoad load_of_hinge(const JointPair& pair, const HingeJoint&, const Joint& joint) {
    return {joint.point, joint.turn + axis_of(pair) * along_axis(joint)};
}

}  // namespace jostle::physics
