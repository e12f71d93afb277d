// SPDX-License-Identifier: MIT
#include "constraints/joints/kinds.h"

namespace jostle::physics {

double twist_angle(Quat frame_a, Quat frame_b) {
    const Quat q = conjugate(frame_a) * frame_b;
    const double angle = 2 * arc_tangent(q.x, q.w);
    return angle > pi ? angle - 2 * pi : (angle < -pi ? angle + 2 * pi : angle);
}

double swing_angle(Quat frame_a, Quat frame_b) {
    const Vec3 a = rotate(frame_a, {1, 0, 0}), b = rotate(frame_b, {1, 0, 0});
    return arc_tangent(length(cross(a, b)), dot(a, b));
}

namespace {

struct Axes {
    Vec3 swing;  // about which b's x axis turns away from a's
    Vec3 twist;  // b's spin against a, times this, is the rate of the twist angle
};

Axes axes_of(const JointPair& pair) {
    const Vec3 a = rotate(pair.frame_a, {1, 0, 0}), b = rotate(pair.frame_b, {1, 0, 0});
    const Vec3 across = rotate(pair.frame_a, {0, 1, 0});
    // At a swing of a half turn there is no twist to speak of.
    const double fold = maximum(0.05, 1 + dot(a, b));
    return {normalized(cross(a, b), across), (a + b) * (1 / fold)};
}

Vec3 turn_of(const Axes& axes, const Joint& joint) {
    return axes.twist * (joint.lower - joint.upper) - axes.swing * joint.swing + joint.drive;
}

}  // namespace

void warm_start_cone_twist(JointPair& pair, const ConeTwistJoint&, Joint& joint) {
    pair.push(joint.point);
    pair.turn(turn_of(axes_of(pair), joint));
}

void solve_cone_twist(JointPair& pair, const JointStep& step, const ConeTwistJoint& kind,
                      Joint& joint) {
    const Axes axes = axes_of(pair);
    if (kind.friction_torque > 0) {
        const Vec3 before = joint.drive;
        Vec3 now = before;
        now -= inverse(pair.turn_matrix()) * pair.spin();
        const double most = kind.friction_torque * step.h, size = length(now);
        joint.drive = size > most ? now * (most / size) : now;
        pair.turn(joint.drive - before);
    } else {
        joint.drive = {};
    }
    if (kind.twist.enabled) {
        const double twist = twist_angle(pair.frame_a, pair.frame_b);
        const Row row = angle_row(pair, axes.twist);
        limit_row(pair, step, row, twist - kind.twist.lower, joint.lower);
        limit_row(pair, step, {-axes.twist, true, row.inverse_mass}, kind.twist.upper - twist,
                  joint.upper);
    } else {
        joint.lower = joint.upper = 0;
    }
    const double swing = swing_angle(pair.frame_a, pair.frame_b);
    limit_row(pair, step, angle_row(pair, -axes.swing), kind.swing - swing, joint.swing);
    hold_points(pair, step, step.rigid, joint.point);
}

JointLoad load_of_cone_twist(const JointPair& pair, const ConeTwistJoint&, const Joint& joint) {
    return {joint.point, turn_of(axes_of(pair), joint)};
}

}  // namespace jostle::physics
