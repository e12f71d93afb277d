// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/write_joint.h"

#include <cstdlib>
#include <optional>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/joints/axes_layout.h"
#include "physics/src/constraints/joints/gear_ends.h"
#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/constraints/joints/write_axes.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

struct JointWriteContext {
    const Joint& joint;
    const JointEnd &a, &b;
    double h;
    const JointLane& lane;
    JointAngularWide& t;
    std::uint8_t uses = 0;

    void limit(bool enabled, double lower, double upper) {
        lane.put_limit(t, enabled ? lower : double{-never}, enabled ? upper : double{never});
        lane.put(t.lower, stored(enabled, joint.lower));
        ASSERT(!enabled || lower <= upper);
        lane.put(t.upper, stored(enabled, joint.upper));
        if (enabled) uses |= uses_limit;
    }
    void spring(bool enabled, const Softness& softness, double at) {
        lane.put(t.spring_soft, enabled ? softness : switched_off);
        lane.put(t.spring_at, at);
        lane.put(t.spring, stored(enabled, joint.spring));
        if (enabled) uses |= uses_spring;
    }
    void motor(bool enabled, double speed, double most) {
        lane.put(t.motor_speed, speed);
        ASSERT(!enabled || most >= 0);
        lane.put(t.motor_most, enabled ? most * h : 0);
        lane.put(t.motor, stored(enabled, joint.motor));
        if (enabled) uses |= uses_motor;
    }
    void frames() {
        lane.put(t.frame_a, a.frame);
        lane.put(t.frame_b, b.frame);
    }

    void operator()(const auto&) {}  // writes its data elsewhere
    void drive(const RotationDrive& drive) {
        const bool driven = drive.spring.hertz > 0;
        lane.put(t.spring_soft, driven ? held_spring_or(drive.spring, h, {}) : switched_off);
        lane.put(t.drive_most, driven ? drive.max_torque * h : 0);
        if (!driven) return;
        lane.put(t.drive, b.frame * conjugate(a.frame * unit(drive.target)));
        uses |= uses_drive;
    }

    void operator()(const BallJoint& kind) {
        motor(kind.friction_torque > 0, 0, kind.friction_torque);
        drive(kind.drive);
    }
    void operator()(const HingeJoint& kind) {
        frames();
        limit(kind.limit.enabled, kind.limit.lower, kind.limit.upper);
        spring(kind.spring.hertz > 0, held_spring_or(kind.spring, h, {}), kind.spring_angle);
        lane.put(t.drive_most, strongest(kind.spring_max_torque, h));
        motor(kind.motor.enabled, kind.motor.speed, kind.motor.max_torque);
    }
    void operator()(const ConeTwistJoint& kind) {
        frames();
        limit(kind.twist.enabled, kind.twist.lower, kind.twist.upper);
        motor(kind.friction_torque > 0, 0, kind.friction_torque);
        lane.put(t.swing_at, kind.swing);
        lane.put(t.swing, joint.swing);
        drive(kind.drive);
    }
    void operator()(const FixedJoint& kind) {
        // Both frames combined into one rotation, so that small angles keep their precision.
        lane.put(t.frame_b, b.frame * conjugate(a.frame));
        lane.put(t.spring_soft, spring_or(kind.angular, h, as_stiff_as_can_be));
        lane.put(t.point_soft, spring_or(kind.linear, h, as_stiff_as_can_be));
    }
    void operator()(const GrabJoint& kind) {
        lane.put(t.point_soft, spring_or(kind.spring, h, switched_off));
        lane.put(t.motor_most, minimum(kind.max_force * h, 1e30));
        const bool damped = kind.angular_damping > 0;
        lane.put(t.spring_soft, damped ? damper(kind.angular_damping, h) : switched_off);
        if (damped) uses |= uses_spring;
    }
    void operator()(const DistanceJoint& kind) {
        const bool rod = kind.min_length == kind.max_length;
        limit(!rod, kind.min_length, kind.max_length);
        if (rod)
            spring(true, as_stiff_as_can_be, kind.min_length);
        else
            spring(kind.spring.hertz > 0, spring_or(kind.spring, h, {}), kind.rest_length);
    }
};

void write_row(const VelocityRow& row, double impulse, const JointEnd& a, const JointEnd& b,
               double h, VelocityRowWide& to, const JointLane& lane) {
    const auto put = [&](float(*rows)[8], Vec3 v, const JointEnd& end) {
        lane.put(rows, row.world_axes ? v : rotate(end.frame, v));
    };
    put(to.linear_a, row.linear_a, a);
    put(to.angular_a, row.angular_a, a);
    put(to.linear_b, row.linear_b, b);
    put(to.angular_b, row.angular_b, b);
    lane.put(to.turns, row.world_axes ? 0 : 1);
    ASSERT(h > 0 && row.lower <= row.upper);
    lane.put(to.speed, row.speed);
    lane.put(to.bias, row.bias);
    lane.put(to.softness, row.softness / h);
    lane.put(to.lower, row.lower * h);
    lane.put(to.upper, row.upper * h);
    lane.put(to.impulse, impulse);
}

}  // namespace

std::int32_t carrier_of(const JointKind& kind, std::int32_t a, std::int32_t b) {
    // Most kinds precede the first such kind.
    static constexpr std::size_t first = 6;
    static_assert(std::is_same_v<std::variant_alternative_t<first, JointKind>, SliderJoint>);
    if (b <= 0) return a;
    return kind.index() >= first && turns_with_a(kind) ? a : b;
}

void write_joint(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                 const JointBlock& to, int lane_index) {
    const JointLane lane{lane_index};
    Vec3 arm_a = a.arm;
    ASSERT(h > 0 && lane_index >= 0 && lane_index < 8);
    std::optional<PathPoint> path_point;
    if (const auto* grab = std::get_if<GrabJoint>(&joint.kind)) {
        arm_a += rotate(a.frame, grab->target);
    } else if (const auto* path = std::get_if<PathJoint>(&joint.kind)) {
        const Vec3 bead = inverse_rotate(a.frame, (b.center - a.center) + (b.arm - a.arm));
        const std::vector<double>& memory = joint.memory;
        ASSERT(memory.size() == PathMemory::count);
        path_point = memory[PathMemory::found] == 0
                         ? nearest_path_point(*path, bead)
                         : nearest_path_point(*path, bead, memory[PathMemory::at]);
        to.axes->at[lane.at] = path_point->at;
        // The circle that approximates the curve in this step touches it in the middle of b's
        // displacement.
        if (path->smooth)
            path_point = path_point_at(
                *path, path_point->at + maximum(-0.5, minimum(memory[PathMemory::step] / 2, 0.5)));
        arm_a += rotate(a.frame, path_point->position);
    }
    JointConstraintWide& block = to.block;
    const std::int32_t carrier = carrier_of(joint.kind, a.hot, b.hot);
    const Quat carried = carrier <= 0 ? Quat{} : (carrier == b.hot ? b.rotation : a.rotation);
    block.a[lane.at] = std::abs(a.hot);
    block.b[lane.at] = std::abs(b.hot);
    lane.put(block.arm_a, arm_a);
    lane.put(block.arm_b, b.arm);
    lane.put(block.apart, (b.center - a.center) + (b.arm - arm_a));
    lane.put(block.point, rotate(carried, joint.point));
    if (to.row != nullptr)
        write_row(std::get<VelocityRow>(joint.kind), joint.motor, a, b, h, *to.row, lane);
    if (to.axes != nullptr)
        to.meta.uses |=
            write_axes(joint, a, b, h, path_point ? &*path_point : nullptr, *to.axes, lane);
    if (to.angular == nullptr) return;
    JointAngularWide& angular = *to.angular;
    lane.put(angular.angular, rotate(carried, joint.angular));
    JointWriteContext parts{joint, a, b, h, lane, angular};
    std::visit(parts, joint.kind);
    if ((parts.uses & uses_motor) != 0) lane.put(angular.friction, rotate(carried, joint.friction));
    to.meta.uses |= parts.uses;
}

bool read_joint(Joint& joint, Quat carried, double dt, const JointBlock& from, int lane_index) {
    const JointLane lane{lane_index};
    const JointConstraintWide& block = from.block;
    joint.point = inverse_rotate(carried, lane.get3(block.point));
    joint.force = lane.get3(block.force) * (1 / dt);
    if (from.row != nullptr) {
        joint.motor = lane.get(from.row->impulse);
        joint.torque = lane.get3(from.row->torque) * (1 / dt);
    }
    if (from.gear != nullptr) read_gear(joint, *from.gear, dt, lane);
    if (from.axes != nullptr) read_axes(joint, *from.axes, dt, lane);
    if (const JointAngularWide* angular = from.angular; angular != nullptr) {
        joint.angular = inverse_rotate(carried, lane.get3(angular->angular));
        joint.friction = inverse_rotate(carried, lane.get3(angular->friction));
        joint.lower = lane.get(angular->lower);
        joint.upper = lane.get(angular->upper);
        joint.swing = lane.get(angular->swing);
        joint.spring = lane.get(angular->spring);
        joint.motor = lane.get(angular->motor);
        joint.torque = lane.get3(angular->torque) * (1 / dt);
    }
    return exceeds_break_limit(joint);
}

bool exceeds_break_limit(const Joint& joint) {
    return (joint.break_force > 0 && length(joint.force) > joint.break_force) ||
           (joint.break_torque > 0 && length(joint.torque) > joint.break_torque);
}

JointStep joint_step(double h) {
    const Softness s = soft(tuning::joint_stiffness / h, tuning::joint_damping_ratio, h);
    return {.h = as_float(h),
            .inverse_h = as_float(1 / h),
            .position_rate = as_float(s.position_rate),
            .velocity_scale = as_float(s.velocity_scale),
            .impulse_scale = as_float(s.impulse_scale),
            .direct_rate = as_float(tuning::direct_joint_correction / h),
            .push_speed = as_float(tuning::joint_push_speed),
            .push_spin = as_float(tuning::joint_push_spin)};
}

}  // namespace jostle::physics
