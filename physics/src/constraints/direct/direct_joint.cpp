// SPDX-License-Identifier: MIT
#include "constraints/direct/direct_joint.h"

#include "foundation/check.h"

namespace jostle::physics {
namespace {

void clear(DirectJoint& joint, int row) {
    joint.angular_a[row] = joint.angular_b[row] = {};
}

// Both bodies feel the force in one point, half-way across what is left between the ends: the
// angular momentum of the two is then kept exactly, gap or not.
void write_points(DirectJoint& j, Vec3 arm_a, Vec3 arm_b, Vec3 apart) {
    j.lever_a = arm_a + apart * 0.5;
    j.lever_b = arm_b - apart * 0.5;
    const Vec3 &a = j.lever_a, &b = j.lever_b;
    if (j.points == 3) {
        j.angular_a[0] = {0, -a.z, a.y};
        j.angular_a[1] = {a.z, 0, -a.x};
        j.angular_a[2] = {-a.y, a.x, 0};
        j.angular_b[0] = {0, b.z, -b.y};
        j.angular_b[1] = {-b.z, 0, b.x};
        j.angular_b[2] = {b.y, -b.x, 0};
    } else {
        j.angular_a[0] = -cross(a, j.line);
        j.angular_b[0] = cross(b, j.line);
    }
}

void write_turn(DirectJoint& j, int k, Vec3 of_a, Vec3 of_b) {
    j.angular_a[j.points + k] = cross(of_a, of_b);
    j.angular_b[j.points + k] = -j.angular_a[j.points + k];
}

void write_axis(DirectJoint& j, Vec3 axis) {
    for (int row = j.limit_row(); row < j.rows(); row++) {
        j.angular_a[row] = -axis;
        j.angular_b[row] = axis;
    }
}

void clear_off(DirectJoint& j) {
    for (int row = 0; row < j.rows(); row++)
        if (j.off[static_cast<std::size_t>(row)]) clear(j, row);
}

double angle_of(const DirectJoint& j, const Mat3& a, const Mat3& b) {
    const Vec3 x = b * j.x_b;
    return arc_tangent(dot(x, a * j.y_a), dot(x, a * j.x_a));
}

// Within a turn.
double wrapped(double angle) {
    return angle > pi ? angle - 2 * pi : (angle < -pi ? angle + 2 * pi : angle);
}

void measure_at(DirectJoint& j, Vec3 xa, const Mat3& a, Vec3 xb, const Mat3& b, double* error) {
    const Vec3 apart = (xb + b * j.arm_b) - (xa + a * j.arm_a);
    if (j.points == 3)
        error[0] = apart.x, error[1] = apart.y, error[2] = apart.z;
    else if (j.points == 1)
        error[0] = length(apart) - j.distance;
    for (int k = 0; k < j.turns; k++) error[j.points + k] = dot(a * j.turn_a[k], b * j.turn_b[k]);
}

}  // namespace

void write_vectors(DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const Vec3 arm_a = a.axes * j.arm_a, arm_b = b.axes * j.arm_b;
    j.apart = (b.x + arm_b) - (a.x + arm_a);
    if (j.points == 1) j.line = normalized(j.apart);
    if (j.points > 0) write_points(j, arm_a, arm_b, j.points == 3 ? j.apart : Vec3{});
    for (int k = 0; k < j.turns; k++) write_turn(j, k, a.axes * j.turn_a[k], b.axes * j.turn_b[k]);
    if (j.has_limit || j.has_motor) write_axis(j, a.axes * j.axis_a);
    clear_off(j);
}

void write_mean_vectors(DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const auto mean = [](const DirectBody& body, Vec3 v) {
        return (body.axes * v + body.axes1 * v) * 0.5;
    };
    const Vec3 arm_a = mean(a, j.arm_a), arm_b = mean(b, j.arm_b);
    const Vec3 apart = ((b.x + b.x1) * 0.5 + arm_b) - ((a.x + a.x1) * 0.5 + arm_a);
    if (j.points == 1) {
        // The lengths' difference is the mean way along it, exactly.
        const Vec3 before = (b.x + b.axes * j.arm_b) - (a.x + a.axes * j.arm_a);
        const Vec3 after = (b.x1 + b.axes1 * j.arm_b) - (a.x1 + a.axes1 * j.arm_a);
        const double sum = length(before) + length(after);
        j.line = sum > 1e-12 ? (before + after) * (1 / sum) : Vec3{0, 1, 0};
    }
    if (j.points > 0) write_points(j, arm_a, arm_b, j.points == 3 ? apart : Vec3{});
    for (int k = 0; k < j.turns; k++) write_turn(j, k, mean(a, j.turn_a[k]), mean(b, j.turn_b[k]));
    if (j.has_limit || j.has_motor) write_axis(j, normalized(mean(a, j.axis_a)));
    clear_off(j);
}

void measure_start(DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    measure_at(j, a.x, a.axes, b.x, b.axes, j.start);
    if (!j.has_limit && !j.has_motor) return;
    const double angle = angle_of(j, a.axes, b.axes);
    for (int row = j.limit_row(); row < j.rows(); row++) j.start[row] = angle;
}

void measure(DirectJoint& j, const DirectBody& a, const DirectBody& b, double h) {
    measure_at(j, a.x1, a.axes1, b.x1, b.axes1, j.error);
    if (!j.has_limit && !j.has_motor) return;
    const double angle = angle_of(j, a.axes1, b.axes1);
    if (j.has_limit)
        j.error[j.limit_row()] = j.at_limit == 0 ? 0 : angle - (j.at_limit > 0 ? j.lower : j.upper);
    if (j.has_motor)
        j.error[j.motor_row()] =
            j.at_most != 0 ? 0 : wrapped(wrapped(angle - j.start[j.motor_row()]) - j.speed * h);
}

double trial_angle(const DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    return angle_of(j, a.axes1, b.axes1);
}

// ---- kinds ----

namespace {

bool turns_freely(const JointAxis& axis) {
    return axis.free && !axis.limit.enabled && axis.spring.hertz == 0 && !axis.motor.enabled &&
           axis.friction == 0;
}

// A six-dof that is a fixed joint, or a ball.
bool all_locked(const SixDofAxes& a) {
    return !a.turn_x.free && !a.turn_y.free && !a.turn_z.free;
}
bool all_turn(const SixDofAxes& a) {
    return turns_freely(a.turn_x) && turns_freely(a.turn_y) && turns_freely(a.turn_z);
}

void set_up_fixed(DirectJoint& j, const Mat3& fa, const Mat3& fb) {
    j.turns = 3;
    j.turn_a[0] = fa.x, j.turn_b[0] = fb.y;
    j.turn_a[1] = fa.y, j.turn_b[1] = fb.z;
    j.turn_a[2] = fa.z, j.turn_b[2] = fb.x;
}

}  // namespace

bool supported(const JointKind& kind) {
    if (const auto* six = std::get_if<SixDofJoint>(&kind)) {
        const SixDofAxes& a = *six->axes;
        return !a.x.free && !a.y.free && !a.z.free && (all_locked(a) || all_turn(a));
    }
    if (const auto* ball = std::get_if<BallJoint>(&kind))
        return ball->drive.spring.hertz == 0 && ball->friction_torque == 0;
    if (const auto* hinge = std::get_if<HingeJoint>(&kind)) return hinge->spring.hertz == 0;
    if (const auto* fixed = std::get_if<FixedJoint>(&kind))
        return fixed->linear.hertz == 0 && fixed->angular.hertz == 0;
    if (const auto* distance = std::get_if<DistanceJoint>(&kind))
        return distance->min_length == distance->max_length && distance->max_length > 0;
    return false;
}

void set_up(DirectJoint& j, const JointKind& kind, const DirectEnd& a, const DirectEnd& b) {
    ASSERT(supported(kind));
    j.arm_a = a.arm;
    j.arm_b = b.arm;
    const Mat3 fa = to_matrix(a.frame), fb = to_matrix(b.frame);
    if (const auto* distance = std::get_if<DistanceJoint>(&kind)) {
        j.points = 1;
        j.distance = distance->max_length;
        return;
    }
    j.points = 3;
    if (const auto* hinge = std::get_if<HingeJoint>(&kind)) {
        j.turns = 2;
        j.turn_a[0] = j.turn_a[1] = fa.z;
        j.turn_b[0] = fb.x;
        j.turn_b[1] = fb.y;
        j.axis_a = fa.z;
        j.x_a = fa.x, j.y_a = fa.y, j.x_b = fb.x;
        j.has_limit = hinge->limit.enabled;
        j.lower = hinge->limit.lower;
        j.upper = hinge->limit.upper;
        j.has_motor = hinge->motor.enabled;
        j.speed = hinge->motor.speed;
        j.most_torque = hinge->motor.max_torque;
    } else if (const auto* six = std::get_if<SixDofJoint>(&kind)) {
        if (all_locked(*six->axes)) set_up_fixed(j, fa, fb);
    } else if (std::holds_alternative<FixedJoint>(kind)) {
        set_up_fixed(j, fa, fb);
    }
}

// ---- what is kept ----

// Forces are halves, of the two halves of a step.
void load_forces(DirectJoint& j, const KeptImpulses& kept, double h) {
    const double half = 0.5 / h;
    if (j.points == 3)
        for (int k = 0; k < 3; k++) j.force[k] = kept.point[k] * half;
    else if (j.points == 1)
        j.force[0] = kept.spring * half;
    // The rows of the turns are perpendicular where joints hold.
    for (int k = j.points; k < j.limit_row(); k++) {
        const double size = length_squared(j.angular_b[k]);
        j.force[k] = size > 1e-6 ? dot(j.angular_b[k], kept.angular) * half / size : 0;
    }
    if (j.has_limit) {
        j.at_limit = kept.lower > 0 ? 1 : (kept.upper > 0 ? -1 : 0);
        j.force[j.limit_row()] = (kept.lower - kept.upper) * half;
    }
    if (j.has_motor) {
        double& force = j.force[j.motor_row()];
        force = kept.motor * half;
        if (absolute(force) >= 0.4999999 * j.most_torque) {
            j.at_most = force > 0 ? 1 : -1;
            force = j.at_most * 0.5 * j.most_torque;
        }
    }
}

KeptImpulses keep_forces(const DirectJoint& j, double h) {
    const double both = 2 * h;
    KeptImpulses kept;
    if (j.points == 3)
        kept.point = Vec3{j.force[0], j.force[1], j.force[2]} * both;
    else if (j.points == 1)
        kept.spring = j.force[0] * both;
    for (int k = j.points; k < j.limit_row(); k++)
        kept.angular += j.angular_b[k] * (j.force[k] * both);
    if (j.has_limit) {
        const double impulse = j.force[j.limit_row()] * both;
        kept.lower = j.at_limit > 0 ? maximum(impulse, 1e-300) : 0;
        kept.upper = j.at_limit < 0 ? maximum(-impulse, 1e-300) : 0;
    }
    if (j.has_motor) kept.motor = j.force[j.motor_row()] * both;
    return kept;
}

}  // namespace jostle::physics
