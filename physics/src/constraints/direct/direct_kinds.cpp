// SPDX-License-Identifier: MIT
//
// Converts the joint kinds to rows and free axes.
#include <iterator>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/constraints/joints/axes_layout.h"
#include "physics/src/constraints/joints/path_curve.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

using AxisKind = FreeAxis::Kind;

void limit(FreeAxis& free_axis, const JointLimit& limit) {
    if (!limit.enabled) return;
    free_axis.lower = limit.lower;
    free_axis.upper = limit.upper;
    free_axis.reference = 0.5 * (limit.lower + limit.upper);
}

void spring(FreeAxis& free_axis, const JointSpring& spring, double rest) {
    free_axis.rate = 2 * pi * spring.hertz;
    ASSERT(spring.hertz >= 0 && spring.damping_ratio >= 0);
    free_axis.damping_ratio = spring.damping_ratio;
    free_axis.rest = rest;
}

void actuation(FreeAxis& free_axis, bool driven, double speed, double most, double friction) {
    if (driven) add_step(free_axis, speed, most);
    ASSERT(friction >= 0);
    if (friction > 0) add_step(free_axis, 0, friction);
    free_axis.friction_limit = friction;
    load_actuation(free_axis, 0);
}

bool does_something(const JointAxis& axis) {
    return axis.free &&
           (axis.limit.enabled || axis.spring.hertz > 0 || axis.motor.enabled || axis.friction > 0);
}

FreeAxis make_free_axis(AxisKind kind, const JointAxis& axis, int slot) {
    FreeAxis free_axis{.kind = kind, .slot = slot};
    limit(free_axis, axis.limit);
    spring(free_axis, axis.spring, axis.spring_target);
    actuation(free_axis, axis.motor.enabled, axis.motor.speed, axis.motor.max_force, axis.friction);
    return free_axis;
}

void as_hinge(FreeAxis& free_axis, Vec3 axis, Vec3 x, Vec3 y, Vec3 x_b) {
    free_axis.kind = AxisKind::hinge;
    free_axis.axis_a = axis;
    free_axis.x_a = x;
    free_axis.y_a = y;
    free_axis.x_b = x_b;
    ASSERT(is_unit(axis, 1e-5) && is_unit(x_b, 1e-5));
}

void hold_axis(DirectJoint& j, Vec3 axis_a, Vec3 x_b, Vec3 y_b) {
    j.turns = 2;
    j.turn_a[0] = j.turn_a[1] = axis_a;
    j.turn_b[0] = x_b;
    j.turn_b[1] = y_b;
}

void hold_all(DirectJoint& j, const Mat3& a, const Mat3& b) {
    j.turns = 3;
    j.turn_a[0] = a.x, j.turn_b[0] = b.y;
    j.turn_a[1] = a.y, j.turn_b[1] = b.z;
    j.turn_a[2] = a.z, j.turn_b[2] = b.x;
}

void hold_together(DirectJoint& j) {
    j.kind = DirectJoint::Points::ball;
    j.points = 3;
}

void set_up_points(DirectJoint& j, const AxesLayout& layout, const Mat3& a) {
    const Vec3 axes[] = {a.x, a.y, a.z};
    int locked = 0;
    for (std::size_t k = 0; k < 3; k++) locked += layout.axes[k].free ? 0 : 1;
    if (locked == 3) return hold_together(j);
    for (std::size_t k = 0; k < 3; k++) {
        const JointAxis& axis = layout.axes[k];
        if (!axis.free) {
            j.across[j.points++] = axes[k];
            ASSERT(j.points <= 3);
        } else if (does_something(axis)) {
            j.free_axes.push_back(make_free_axis(AxisKind::travel, axis, layout.slots[k]));
            j.free_axes.back().axis_a = axes[k];
        }
    }
}

// If any rotation is locked, the middle one is. A single free rotation is a hinge.
void set_up_turns(DirectJoint& j, const AxesLayout& layout, const Mat3& a, const Mat3& b) {
    const bool first = layout.axes[3].free, middle = layout.axes[4].free,
               last = layout.axes[5].free;
    if (!first && !middle && !last)
        hold_all(j, a, b);
    else if (!first && !middle)
        hold_axis(j, a.z, b.x, b.y);
    else if (!middle && !last)
        hold_axis(j, a.x, b.y, b.z);
    else if (!middle)
        j.turns = 1, j.turn_a[0] = a.x, j.turn_b[0] = b.z;
    constexpr AxisKind kinds[] = {AxisKind::first, AxisKind::middle, AxisKind::last};
    for (std::size_t k = 3; k < 6; k++) {
        if (!does_something(layout.axes[k])) continue;
        FreeAxis free_axis = make_free_axis(kinds[k - 3], layout.axes[k], layout.slots[k]);
        free_axis.frame_a = j.frame_a;
        free_axis.frame_b = j.frame_b;
        if (j.turns == 2 && last)
            as_hinge(free_axis, a.z, a.x, a.y, b.x);
        else if (j.turns == 2)
            as_hinge(free_axis, a.x, a.y, a.z, b.y);
        j.free_axes.push_back(free_axis);
    }
}

void set_up_axes(DirectJoint& j, const AxesLayout& layout, const DirectEnd& a, const DirectEnd& b) {
    j.gimbal = true;
    j.frame_a = a.frame * layout.turn_a;
    j.frame_b = b.frame * layout.turn_b;
    const Mat3 axes_a = to_matrix(j.frame_a), axes_b = to_matrix(j.frame_b);
    set_up_points(j, layout, axes_a);
    set_up_turns(j, layout, axes_a, axes_b);
}

void set_up_kind(DirectJoint& j, const HingeJoint& hinge, const DirectEnd& a, const DirectEnd& b) {
    const Mat3 fa = to_matrix(a.frame), fb = to_matrix(b.frame);
    hold_together(j);
    hold_axis(j, fa.z, fb.x, fb.y);
    if (!hinge.limit.enabled && !hinge.motor.enabled && hinge.spring.hertz == 0) return;
    FreeAxis free_axis;
    as_hinge(free_axis, fa.z, fa.x, fa.y, fb.x);
    limit(free_axis, hinge.limit);
    spring(free_axis, hinge.spring, hinge.spring_angle);
    actuation(free_axis, hinge.motor.enabled, hinge.motor.speed, hinge.motor.max_torque, 0);
    j.free_axes.push_back(free_axis);
}
void set_up_kind(DirectJoint& j, const BallJoint&, const DirectEnd&, const DirectEnd&) {
    hold_together(j);
}
void set_up_kind(DirectJoint& j, const FixedJoint&, const DirectEnd& a, const DirectEnd& b) {
    hold_together(j);
    hold_all(j, to_matrix(a.frame), to_matrix(b.frame));
}
void set_up_kind(DirectJoint& j, const ConeTwistJoint& cone, const DirectEnd& a,
                 const DirectEnd& b) {
    hold_together(j);
    FreeAxis free_axis{.frame_a = a.frame, .frame_b = b.frame};
    if (cone.twist.enabled) {
        free_axis.kind = AxisKind::twist;
        limit(free_axis, cone.twist);
        j.free_axes.push_back(free_axis);
        free_axis.lower = -FreeAxis::never;
        free_axis.reference = 0;
    }
    free_axis.kind = AxisKind::swing;
    free_axis.slot = 1;
    free_axis.upper = cone.swing;
    j.free_axes.push_back(free_axis);
}
void set_up_kind(DirectJoint& j, const DistanceJoint& distance, const DirectEnd&,
                 const DirectEnd&) {
    if (distance.min_length == distance.max_length) {
        j.kind = DirectJoint::Points::rod;
        j.points = 1;
        j.distance = distance.max_length;
        return;
    }
    FreeAxis free_axis{.kind = AxisKind::distance, .upper = distance.max_length};
    if (distance.min_length > 0) free_axis.lower = distance.min_length;
    spring(free_axis, distance.spring, distance.rest_length);
    j.free_axes.push_back(free_axis);
}
void set_up_kind(DirectJoint& j, const PathJoint& path, const DirectEnd& a, const DirectEnd&) {
    j.points = 2;
    j.path = &path;
    j.frame_a = a.frame;
    const Vec3 tangent = rotate(a.frame, curve_point_at(path, 0).tangent);
    j.across[0] =
        normalized(cross(tangent, absolute(tangent.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const JointAxis axis = layout_at(path, {}).axes[0];
    if (!does_something(axis)) return;
    j.path_travels = piece_travels(path);
    j.free_axes.push_back(make_free_axis(AxisKind::path, axis, 0));
    j.free_axes.back().frame_a = a.frame;
}

// ---- gears, racks and pulleys ----

DirectGear& add_gear(DirectJoint& j, const DirectEnd& a, const DirectEnd& b) {
    j.kind = DirectJoint::Points::gear;
    DirectGear& gear = j.gear.emplace_back();
    gear.ends[0] = {.body = j.a, .arm = a.arm, .frame = a.frame};
    gear.ends[1] = {.body = j.b, .arm = b.arm, .frame = b.frame};
    return gear;
}
void set_up_kind(DirectJoint& j, const GearJoint& kind, const DirectEnd& a, const DirectEnd& b) {
    add_gear(j, a, b).ends[1].scale = kind.ratio;
    j.turns = 1;
}
void set_up_kind(DirectJoint& j, const RackJoint& kind, const DirectEnd& a, const DirectEnd& b) {
    DirectGear& gear = add_gear(j, a, b);
    gear.ends[0].scale = -kind.radius;
    gear.ends[1].motion = DirectGear::Motion::slide;
    j.points = 1;
}
// A rope is an upper limit: it only pulls.
void set_up_kind(DirectJoint& j, const PulleyJoint& kind, const DirectEnd& a, const DirectEnd& b) {
    DirectGear& gear = add_gear(j, a, b);
    for (DirectGear::End& end : gear.ends) end.motion = DirectGear::Motion::hang;
    gear.ends[0].point = kind.point_a;
    gear.ends[1].point = kind.point_b;
    gear.ends[1].scale = kind.ratio;
    gear.target = kind.length;
    j.free_axes.push_back({.kind = AxisKind::rope, .upper = kind.length});
}

void set_up_kind(DirectJoint& j, const auto& kind, const DirectEnd& a, const DirectEnd& b) {
    if constexpr (requires { layout_of(kind); })
        set_up_axes(j, layout_of(kind), a, b);
    else
        ASSERT(!supported(JointKind(kind)));  // never called: the kind has no rows in this solver
}

bool supported(const SixDofAxes& axes) {
    bool something = false;
    for (const JointAxis* axis :
         {&axes.x, &axes.y, &axes.z, &axes.rotation_x, &axes.rotation_y, &axes.rotation_z}) {
        if (axis->spring_max_force > 0) return false;
        something |= !axis->free || does_something(*axis);
    }
    return something;
}

}  // namespace

bool supported(const JointKind& kind) {
    if (const auto* six = std::get_if<SixDofJoint>(&kind)) return supported(*six->axes);
    if (const auto* hinge = std::get_if<HingeJoint>(&kind)) return hinge->spring_max_torque == 0;
    if (const auto* slider = std::get_if<SliderJoint>(&kind)) return slider->spring_max_force == 0;
    if (const auto* ball = std::get_if<BallJoint>(&kind))
        return ball->drive.spring.hertz == 0 && ball->friction_torque == 0;
    if (const auto* cone = std::get_if<ConeTwistJoint>(&kind))
        return cone->drive.spring.hertz == 0 && cone->friction_torque == 0;
    if (const auto* fixed = std::get_if<FixedJoint>(&kind))
        return fixed->linear.hertz == 0 && fixed->angular.hertz == 0;
    if (const auto* distance = std::get_if<DistanceJoint>(&kind)) return distance->max_length > 0;
    // At the kinks of a polyline a body loses energy, which this solver would keep or lose
    // depending on how a step meets them.
    if (const auto* path = std::get_if<PathJoint>(&kind))
        return path->smooth || (path->points.size() == 2 && !path->closed);
    return !std::holds_alternative<VelocityRow>(kind) && !std::holds_alternative<GrabJoint>(kind);
}

void set_up_rigid(DirectJoint& j, const JointKind& kind, const DirectEnd& a, const DirectEnd& b) {
    j.arm_a = a.arm;
    j.arm_b = b.arm;
    std::visit([&](const auto& of_kind) { set_up_kind(j, of_kind, a, b); }, kind);
    for (FreeAxis& free_axis : j.free_axes) {
        free_axis.rate = free_axis.friction_limit = 0;
        free_axis.steps = 0;
        free_axis.actuation = FreeAxis::at_rest;
    }
    j.count = j.points + j.turns + static_cast<int>(j.free_axes.size());
    ASSERT(j.count >= 1 && j.count <= static_cast<int>(std::size(j.force)));
}

void set_up(DirectJoint& j, const JointKind& kind, const DirectEnd& a, const DirectEnd& b) {
    ASSERT(supported(kind));
    j.arm_a = a.arm;
    ASSERT(j.free_axes.empty() && j.points == 0 && j.turns == 0);
    j.arm_b = b.arm;
    std::visit([&](const auto& of_kind) { set_up_kind(j, of_kind, a, b); }, kind);
    j.count = j.points + j.turns + static_cast<int>(j.free_axes.size());
    ASSERT(j.count >= 1 && j.count <= static_cast<int>(std::size(j.force)));
}

void set_carriers(DirectJoint& j, const DirectCarrier& of_a, const DirectCarrier& of_b) {
    ASSERT(j.gear.size() == 1);
    const DirectCarrier* const carriers[] = {&of_a, &of_b};
    for (int k = 0; k < 2; k++) {
        DirectGear::End& end = j.gear[0].ends[k];
        end.carrier = carriers[k]->body;
        end.carrier_axes = carriers[k]->axes;
        end.carrier_center = carriers[k]->center;
    }
    list_parts(j.gear[0]);
}

}  // namespace jostle::physics
