// SPDX-License-Identifier: MIT
//
// Table of joint kinds: the name and the fields of each kind, with their ranges, in one place.
// Argument checks, saved worlds, state hashes and scene files iterate over it, so all of them cover
// the same fields.
//
// To add a joint kind, add
// - its struct, listed in JointKind (joint_defs.h), and an entry in this file;
// - a message, and a field named after the kind in Joint (proto/jostle/v1/scene.proto);
// - its row writer (constraints/joints/write_joint.cpp), its kernel
//   (constraints/joints/joint_kinds.h) and its rows for inspection
//   (constraints/joints/joint_rows.cpp);
// - if it reports an angle, or its ends are not coincident, a case in World::joint() and in
//   world/summary.cpp.
//
// A visitor v receives field names as spelled in messages, and ranges in the units of joint_defs.h:
//     v.number(name, x, low, high)
//     v.ordered(name, x, name, y, low, high)    two numbers, x <= y
//     v.later(name, x, low, high, version)      a number, 0 in saved worlds before that version
//     v.drive(name, x)                          a RotationDrive, none before version 12
//     v.vector(name, x, limit)                  the magnitude of each component is at most limit
//     v.flag(name, x)
//     v.points(name, x, min, max, limit)        min to max vectors, adjacent ones distinct
//     v.limit(name, x, low, high)
//     v.spring(name, x)
//     v.motor(name, x)                          a JointMotor, LinearMotor or AxisMotor
//     v.axis(name, x, low, high)                a JointAxis; the range is that of its values
#pragma once

#include <type_traits>
#include <variant>

#include "jostle/physics/joint_defs.h"
#include "jostle/physics/limits.h"
#include "jostle/physics/scalar.h"

namespace jostle::physics {

/// Visits the fields of a limit, except `enabled`. Each visitor represents `enabled` itself: as a
/// byte in a saved world, as the presence of a message in a scene.
void visit_limit(auto& v, auto& limit, double low, double high) {
    v.number("lower", limit.lower, low, high);
    v.number("upper", limit.upper, low, high);
}
/// Visits the fields of a motor, except `enabled`.
void visit_motor(auto& v, auto& motor) {
    v.number("speed", motor.speed, -limits::max_speed, limits::max_speed);
    if constexpr (requires { motor.max_torque; })
        v.number("max_torque", motor.max_torque, 0, 1e12);
    else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(motor)>, AxisMotor>)
        v.number("most", motor.max_force, 0, 1e12);  // N or N m
    else
        v.number("max_force", motor.max_force, 0, 1e12);
}
/// Visits the fields of a spring.
void visit_spring(auto& v, auto& spring) {
    v.number("hertz", spring.hertz, 0, 1e4);
    v.number("damping_ratio", spring.damping_ratio, 0, 1e4);
}

/// Visits the fields of a six-dof axis.
void visit_axis(auto& v, auto& axis, double low, double high) {
    v.flag("free", axis.free);
    v.limit("limit", axis.limit, low, high);
    v.spring("spring", axis.spring);
    v.number("spring_at", axis.spring_target, low, high);
    v.motor("motor", axis.motor);
    v.number("friction", axis.friction, 0, 1e12);
    v.later("spring_most", axis.spring_max_force, 0, 1e12, 16);
}

/// Fields of one joint kind: `name` and visit(v, joint). The order of the fields is that of saved
/// worlds; each change has a line in docs/design/format_changes.md.
template <class Kind>
struct JointFields;

template <>
struct JointFields<BallJoint> {
    static constexpr const char* name = "ball";
    static void visit(auto& v, auto& ball) {
        v.drive("drive", ball.drive);
        v.later("friction_torque", ball.friction_torque, 0, 1e12, 12);
    }
};

template <>
struct JointFields<HingeJoint> {
    static constexpr const char* name = "hinge";
    static void visit(auto& v, auto& hinge) {
        v.limit("limit", hinge.limit, -pi, pi);
        v.motor("motor", hinge.motor);
        v.spring("spring", hinge.spring);
        v.number("spring_angle", hinge.spring_angle, -pi, pi);
        v.later("spring_max_torque", hinge.spring_max_torque, 0, 1e12, 16);
    }
};

template <>
struct JointFields<ConeTwistJoint> {
    static constexpr const char* name = "cone_twist";
    static void visit(auto& v, auto& cone) {
        v.number("swing", cone.swing, 0, pi);
        v.limit("twist", cone.twist, -pi, pi);
        v.number("friction_torque", cone.friction_torque, 0, 1e12);
        v.drive("drive", cone.drive);
    }
};

template <>
struct JointFields<FixedJoint> {
    static constexpr const char* name = "fixed";
    static void visit(auto& v, auto& fixed) {
        v.spring("linear", fixed.linear);
        v.spring("angular", fixed.angular);
    }
};

template <>
struct JointFields<DistanceJoint> {
    static constexpr const char* name = "distance";
    static void visit(auto& v, auto& distance) {
        v.ordered("min_length", distance.min_length, "max_length", distance.max_length, 0, 1e6);
        v.spring("spring", distance.spring);
        v.number("rest_length", distance.rest_length, 0, 1e6);
    }
};

template <>
struct JointFields<VelocityRow> {
    static constexpr const char* name = "velocity_row";
    static void visit(auto& v, auto& row) {
        v.vector("linear_a", row.linear_a, 1e6);
        v.vector("angular_a", row.angular_a, 1e6);
        v.vector("linear_b", row.linear_b, 1e6);
        v.vector("angular_b", row.angular_b, 1e6);
        v.flag("world_axes", row.world_axes);
        v.number("speed", row.speed, -1e9, 1e9);
        v.number("bias", row.bias, -1e9, 1e9);
        v.number("softness", row.softness, 0, 1e9);
        v.ordered("lower", row.lower, "upper", row.upper, -1e15, 1e15);
    }
};

template <>
struct JointFields<SliderJoint> {
    static constexpr const char* name = "slider";
    static void visit(auto& v, auto& slider) {
        v.limit("limit", slider.limit, -1e6, 1e6);
        v.motor("motor", slider.motor);
        v.spring("spring", slider.spring);
        v.number("spring_travel", slider.spring_travel, -1e6, 1e6);
        v.number("friction_force", slider.friction_force, 0, 1e12);
        v.later("spring_max_force", slider.spring_max_force, 0, 1e12, 16);
    }
};

template <>
struct JointFields<SixDofJoint> {
    static constexpr const char* name = "six_dof";
    static void visit(auto& v, auto& six) {
        v.axis("x", six.axes->x, -1e6, 1e6);
        v.axis("y", six.axes->y, -1e6, 1e6);
        v.axis("z", six.axes->z, -1e6, 1e6);
        v.axis("turn_x", six.axes->rotation_x, -pi, pi);
        v.axis("turn_y", six.axes->rotation_y, -pi, pi);
        v.axis("turn_z", six.axes->rotation_z, -pi, pi);
    }
};

template <>
struct JointFields<WheelJoint> {
    static constexpr const char* name = "wheel";
    static void visit(auto& v, auto& wheel) {
        v.spring("suspension", wheel.suspension);
        v.number("ride", wheel.suspension_target, -1e6, 1e6);
        v.limit("travel", wheel.travel, -1e6, 1e6);
        v.number("steering", wheel.steering, -pi, pi);
        v.flag("free_steering", wheel.free_steering);
        v.limit("steering_limit", wheel.steering_limit, -pi, pi);
        v.motor("motor", wheel.motor);
        v.number("friction_torque", wheel.friction_torque, 0, 1e12);
    }
};

template <>
struct JointFields<GrabJoint> {
    static constexpr const char* name = "grab";
    static void visit(auto& v, auto& grab) {
        v.vector("target", grab.target, 1e6);
        v.spring("spring", grab.spring);
        v.number("max_force", grab.max_force, 0, 1e15);
        v.number("turn_damping", grab.angular_damping, 0, 1e6);
    }
};

template <>
struct JointFields<GearJoint> {
    static constexpr const char* name = "gear";
    static void visit(auto& v, auto& gear) { v.number("ratio", gear.ratio, -1e6, 1e6); }
};

template <>
struct JointFields<RackJoint> {
    static constexpr const char* name = "rack";
    static void visit(auto& v, auto& rack) { v.number("radius", rack.radius, -1e6, 1e6); }
};

template <>
struct JointFields<PulleyJoint> {
    static constexpr const char* name = "pulley";
    static void visit(auto& v, auto& pulley) {
        v.vector("point_a", pulley.point_a, 1e6);
        v.vector("point_b", pulley.point_b, 1e6);
        v.number("length", pulley.length, 0, 1e6);
        v.number("ratio", pulley.ratio, 1e-3, 1e3);
    }
};

template <>
struct JointFields<PathJoint> {
    static constexpr const char* name = "path";
    static void visit(auto& v, auto& path) {
        v.points("points", path.points, 2, 1024, 1e6);
        v.flag("smooth", path.smooth);
        v.flag("closed", path.closed);
        v.limit("limit", path.limit, 0, 1e9);
        v.motor("motor", path.motor);
        v.spring("spring", path.spring);
        v.number("spring_travel", path.spring_travel, 0, 1e9);
        v.number("friction_force", path.friction_force, 0, 1e12);
    }
};

/// Calls each(joint) with a default-constructed struct of every kind, in the order of JointKind.
void for_each_joint_kind(auto&& each) {
    [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
        (each(Kinds{}), ...);
    }(std::type_identity<JointKind>{});
}

}  // namespace jostle::physics
