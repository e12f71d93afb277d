// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/joint_rows.h"

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/joints/angles.h"
#include "physics/src/constraints/joints/axes_layout.h"

namespace jostle::physics {
namespace {

constexpr Vec3 axes_of_world[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// The shorter rotation from `from` to `to`, as a rotation vector.
Vec3 turn_between(Quat from, Quat to) {
    const Quat q = to * conjugate(from);
    const Vec3 axis = Vec3{q.x, q.y, q.z} * (q.w < 0 ? -1.0 : 1.0);
    const double sine = length(axis);
    if (sine < 1e-9) return axis * 2;
    return axis * (2 * arc_tangent(sine, absolute(q.w)) / sine);
}

// Between limits a spring never pulls through them. Otherwise it pulls the shorter way.
double spring_error(const JointLimit& limit, double angle, double rest) {
    return limit.enabled ? angle - rest : nearest_angle(angle, rest) - rest;
}

constexpr double unused[AxisImpulses::count] = {};

struct JointRowWriter {
    const Joint& joint;
    const JointEnd &a, &b;
    const Carrier* carriers;
    std::vector<JointRow> rows = {};
    int blocks = 0;

    Vec3 apart() const { return (b.center - a.center) + (b.arm - a.arm); }

    // The velocity of b's point relative to a's along a direction. The points are at these arms.
    JointRow along(RowRole role, int axis, Vec3 direction, Vec3 arm_a, Vec3 arm_b) const {
        JointRow row{.role = role, .axis = axis};
        row.jacobians[0] = {joint.body_a, -direction, -cross(arm_a, direction)};
        row.jacobians[1] = {joint.body_b, direction, cross(arm_b, direction)};
        row.jacobian_count = 2;
        return row;
    }
    // The spin of b relative to a about a direction.
    JointRow about(RowRole role, int axis, Vec3 direction) const {
        JointRow row{.role = role, .axis = axis};
        row.jacobians[0] = {joint.body_a, {}, -direction};
        row.jacobians[1] = {joint.body_b, {}, direction};
        row.jacobian_count = 2;
        return row;
    }
    JointRow& add(const JointRow& row) { return rows.emplace_back(row); }

    // Rows of a degree of freedom that is not locked. `row` is its rate.
    void limits(const JointRow& row, const JointLimit& limit, double value) {
        if (!limit.enabled) return;
        ASSERT(limit.lower <= limit.upper);
        JointRow& lower = add(row);
        lower.role = RowRole::limit;
        lower.error = value - limit.lower;
        if (limit.lower == limit.upper) return;
        lower.one_sided = true;
        JointRow& upper = add(row);
        upper.role = RowRole::limit;
        upper.one_sided = true;
        upper.error = limit.upper - value;
        for (JointRowJacobian& part : upper.jacobians)
            part.linear = -part.linear, part.angular = -part.angular;
    }
    void spring(const JointRow& row, const JointSpring& spring, double error, double most = 0) {
        if (spring.hertz == 0) return;
        ASSERT(spring.hertz > 0 && most >= 0);
        JointRow& added = add(row);
        added.role = RowRole::spring;
        added.spring = spring;
        added.error = error;
        if (most == 0) return;
        added.lower = -most;
        added.upper = most;
    }
    void motor(const JointRow& row, bool enabled, double speed, double most) {
        if (!enabled) return;
        JointRow& added = add(row);
        added.role = RowRole::motor;
        added.speed = speed;
        added.lower = -most;
        added.upper = most;
    }
    void friction(const JointRow& row, double most) {
        if (most == 0) return;
        JointRow& added = add(row);
        added.role = RowRole::friction;
        added.lower = -most;
        added.upper = most;
    }

    // Rows that several kinds share.
    void hold_points(const JointSpring& spring = {}) {
        const Vec3 gap = apart();
        const double error[] = {gap.x, gap.y, gap.z};
        for (int k = 0; k < 3; k++) {
            JointRow& row = add(along(RowRole::point, k, axes_of_world[k], a.arm, b.arm));
            row.error = error[k];
            row.spring = spring;
            row.block = blocks;
        }
        blocks++;
    }
    void hold_turns(RowRole role, Vec3 errors, const JointSpring& spring, double most) {
        const double error[] = {errors.x, errors.y, errors.z};
        for (int k = 0; k < 3; k++) {
            JointRow& row = add(about(role, k, axes_of_world[k]));
            row.error = error[k];
            row.spring = spring;
            row.lower = -most;
            row.upper = most;
            row.block = blocks;
        }
        blocks++;
    }
    void rub(double most) {
        if (most == 0) return;
        for (int k = 0; k < 3; k++) friction(about(RowRole::friction, k, axes_of_world[k]), most);
    }
    void drive(const RotationDrive& drive) {
        if (drive.spring.hertz == 0) return;
        hold_turns(RowRole::spring, turn_between(a.frame * unit(drive.target), b.frame),
                   drive.spring, drive.max_torque);
    }

    // ---- kinds ----

    void operator()(const BallJoint& kind) {
        drive(kind.drive);
        rub(kind.friction_torque);
        hold_points();
    }
    void operator()(const HingeJoint& kind) {
        const Mat3 fa = to_matrix(a.frame), fb = to_matrix(b.frame);
        const JointRow axis = about(RowRole::rotation, 2, fa.z);
        const double angle = nearest_angle(hinge_angle(a.frame, b.frame),
                                           reference_angle(kind.limit, joint.lower, joint.upper));
        spring(axis, kind.spring, spring_error(kind.limit, angle, kind.spring_angle),
               kind.spring_max_torque);
        motor(axis, kind.motor.enabled, kind.motor.speed, kind.motor.max_torque);
        limits(axis, kind.limit, angle);
        const Vec3 off = cross(fa.z, fb.z);
        for (int k = 0; k < 2; k++) {
            const Vec3 across = k == 0 ? fa.x : fa.y;
            JointRow& row = add(about(RowRole::rotation, k, across));
            row.error = dot(off, across);
            row.block = blocks;
        }
        blocks++;
        hold_points();
    }
    void operator()(const ConeTwistJoint& kind) {
        const Vec3 xa = rotate(a.frame, {1, 0, 0}), xb = rotate(b.frame, {1, 0, 0});
        const Vec3 away = cross(xa, xb);
        const double sine = length(away), cosine = dot(xa, xb);
        drive(kind.drive);
        rub(kind.friction_torque);
        limits(about(RowRole::limit, 0, (xa + xb) * (1 / maximum(1 + cosine, 0.05))), kind.twist,
               nearest_angle(twist_angle(a.frame, b.frame),
                             reference_angle(kind.twist, joint.lower, joint.upper)));
        const Vec3 swing = sine > 1e-12 ? away * (1 / sine) : rotate(a.frame, Vec3{0, 1, 0});
        JointRow& cone = add(about(RowRole::limit, 1, -swing));
        cone.one_sided = true;
        cone.error = kind.swing - arc_tangent(sine, cosine);
        hold_points();
    }
    void operator()(const FixedJoint& kind) {
        hold_turns(RowRole::rotation, turn_between(a.frame, b.frame), kind.angular, 1e300);
        hold_points(kind.linear);
    }
    void operator()(const DistanceJoint& kind) {
        const Vec3 gap = apart();
        const double now = length(gap);
        const JointRow line =
            along(RowRole::distance, -1, now > 0 ? gap * (1 / now) : Vec3{0, 1, 0}, a.arm, b.arm);
        if (kind.min_length == kind.max_length) {
            add(line).error = now - kind.min_length;
            return;
        }
        spring(line, kind.spring, now - kind.rest_length);
        limits(line, {true, kind.min_length, kind.max_length}, now);
    }
    void operator()(const VelocityRow& kind) {
        const auto turned = [&](Vec3 v, const JointEnd& end) {
            return kind.world_axes ? v : rotate(end.frame, v);
        };
        const Vec3 linear_a = turned(kind.linear_a, a), linear_b = turned(kind.linear_b, b);
        JointRow row{.role = RowRole::velocity};
        row.jacobians[0] = {joint.body_a, linear_a,
                            turned(kind.angular_a, a) + cross(a.arm, linear_a)};
        row.jacobians[1] = {joint.body_b, linear_b,
                            turned(kind.angular_b, b) + cross(b.arm, linear_b)};
        row.jacobian_count = 2;
        row.speed = kind.speed - kind.bias;
        row.compliance = kind.softness;
        row.lower = kind.lower;
        row.upper = kind.upper;
        add(row);
    }
    void operator()(const GrabJoint& kind) {
        if (kind.angular_damping > 0) {
            for (int k = 0; k < 3; k++) {
                JointRow& row = add(about(RowRole::friction, k, axes_of_world[k]));
                row.damper = kind.angular_damping;
                row.block = blocks;
            }
            blocks++;
        }
        if (kind.spring.hertz == 0) return;
        const Vec3 arm_a = a.arm + rotate(a.frame, kind.target);
        const Vec3 gap = (b.center - a.center) + (b.arm - arm_a);
        const double error[] = {gap.x, gap.y, gap.z};
        for (int k = 0; k < 3; k++) {
            JointRow& row = add(along(RowRole::spring, k, axes_of_world[k], arm_a, b.arm));
            row.spring = kind.spring;
            row.error = error[k];
            row.lower = -kind.max_force;
            row.upper = kind.max_force;
            row.block = blocks;
        }
    }

    // Sliders, six-dofs, wheels and paths. `own`: the kind's axis for each axis of the layout.
    // `origin`: origin of a's axes, relative to a's centre of mass.
    void axes(const AxesLayout& layout, const int (&own)[6], Vec3 origin) {
        const Quat frame_a = a.frame * layout.turn_a, frame_b = b.frame * layout.turn_b;
        const Vec3 gap = (b.center - a.center) + (b.arm - origin);
        const GimbalRows turns = gimbal_rows(frame_a, frame_b);
        const GimbalAngles angles = gimbal_angles(frame_a, frame_b);
        const Vec3 rates[] = {turns.first, turns.middle, turns.last};
        const double values[] = {angles.first, angles.middle, angles.last};
        const auto row_of = [&](int k) {
            if (k >= 3) return about(RowRole::rotation, own[k], rates[k - 3]);
            // Rates along a's axes are those of b's point in a's frame, so a's arm extends to that
            // point.
            return along(RowRole::point, own[k], rotate(frame_a, axes_of_world[k]), origin + gap,
                         b.arm);
        };
        const auto value_of = [&](int k) {
            return k < 3 ? dot(rotate(frame_a, axes_of_world[k]), gap) : values[k - 3];
        };
        for (int k = 0; k < 6; k++) {
            if (k == 3) blocks++;
            if (layout.axes[static_cast<std::size_t>(k)].free) continue;
            JointRow& row = add(row_of(k));
            row.error = value_of(k);
            row.block = blocks;
        }
        blocks++;
        for (int k = 0; k < 6; k++) {
            const JointAxis& axis = layout.axes[static_cast<std::size_t>(k)];
            if (!axis.free) continue;
            const JointRow row = row_of(k);
            double value = value_of(k), error = value - axis.spring_target;
            if (k >= 3) {
                const int slot = layout.slots[static_cast<std::size_t>(k)];
                const double* const impulses =
                    slot < 0 ? unused
                             : &joint.memory[static_cast<std::size_t>(slot) * AxisImpulses::count];
                value =
                    nearest_angle(value, reference_angle(axis.limit, impulses[AxisImpulses::lower],
                                                         impulses[AxisImpulses::upper]));
                error = spring_error(axis.limit, value, axis.spring_target);
            }
            friction(row, axis.friction);
            spring(row, axis.spring, error, axis.spring_max_force);
            motor(row, axis.motor.enabled, axis.motor.speed, axis.motor.max_force);
            limits(row, axis.limit, value);
        }
    }
    void operator()(const SliderJoint& kind) { axes(layout_of(kind), {0, 1, 2, 0, 1, 2}, a.arm); }
    void operator()(const SixDofJoint& kind) {
        const int first = (middle_turn(*kind.axes) + 2) % 3, second = (first + 1) % 3,
                  third = (first + 2) % 3;
        axes(layout_of(kind), {first, second, third, first, second, third}, a.arm);
    }
    void operator()(const WheelJoint& kind) { axes(layout_of(kind), {1, 0, 2, 1, 0, 2}, a.arm); }
    void operator()(const PathJoint& kind) {
        const Vec3 bead = inverse_rotate(a.frame, apart());
        const std::vector<double>& memory = joint.memory;
        ASSERT(memory.size() == PathMemory::count);
        const PathPoint path_point = memory[PathMemory::found] == 0
                                         ? nearest_path_point(kind, bead)
                                         : nearest_path_point(kind, bead, memory[PathMemory::at]);
        axes(layout_at(kind, path_point), {0, 1, 2, 0, 1, 2},
             a.arm + rotate(a.frame, path_point.position));
    }

    // Gears, racks and pulleys.
    void gear() {
        const GearTerms terms = gear_terms(joint, a, b, carriers);
        JointRow row{.role = RowRole::gear, .error = terms.sum - terms.target};
        ASSERT(carriers != nullptr);
        for (int k = 0; k < 4; k++) {
            if (!terms.participates[k]) continue;
            JointRowJacobian& part = row.jacobians[row.jacobian_count++];
            part.body = terms.body[k];
            for (int end = 0; end < 2; end++) {
                const GearTerms::End& e = terms.ends[end];
                const Vec3 v = e.axis * (e.sign[k] * e.scale);
                if (!e.turns) part.linear += v;
                part.angular += e.turns ? v : cross(e.arm[k], v);
            }
        }
        if (std::holds_alternative<PulleyJoint>(joint.kind)) {  // never pushes
            for (JointRowJacobian& part : row.jacobians)
                part.linear = -part.linear, part.angular = -part.angular;
            row.one_sided = true;
            row.error = -row.error;
        }
        add(row);
    }
    void operator()(const GearJoint&) { gear(); }
    void operator()(const RackJoint&) { gear(); }
    void operator()(const PulleyJoint&) { gear(); }
};

}  // namespace

std::vector<JointRow> joint_rows(const Joint& joint, const JointEnd& a, const JointEnd& b,
                                 const Carrier* carriers) {
    JointRowWriter writer{joint, a, b, carriers};
    std::visit(writer, joint.kind);
    return std::move(writer.rows);
}

}  // namespace jostle::physics
