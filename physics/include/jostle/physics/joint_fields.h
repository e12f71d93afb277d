// SPDX-License-Identifier: MIT
//
// The table of joint kinds: each states its name and its fields once. Checks, saved worlds, hashes
// and scene files walk it, so none of them can forget a field that another has.
//
// A new kind takes its struct, listed in JointKind (joint_defs.h), and an entry here; a message,
// and a field of the kind's name in Joint (proto/jostle/v1/scene.proto); its writer
// (constraints/joints/write_joint.cpp) and its kernel (constraints/joints/joint_kinds.h). One that
// has an angle to report, or ends that are meant to be apart, says so in World::joint() and in
// world/summary.cpp.
//
// A visitor v takes names as messages spell them, and ranges in the units of joint_defs.h:
//     v.number(name, x, low, high)
//     v.ordered(name, x, name, y, low, high)    two numbers, x <= y
//     v.vector(name, x, limit)                  each component at most that in size
//     v.flag(name, x)
//     v.limit(name, x, low, high)  v.motor(name, x)  v.spring(name, x)
#pragma once

#include <type_traits>
#include <variant>

#include "jostle/physics/joint_defs.h"
#include "jostle/physics/limits.h"
#include "jostle/physics/scalar.h"

namespace jostle::physics {

// What `enabled` means a visitor decides: a byte in a saved world, a message that is there in a
// scene.
void visit_limit(auto& v, auto& limit, double low, double high) {
    v.number("lower", limit.lower, low, high);
    v.number("upper", limit.upper, low, high);
}
void visit_motor(auto& v, auto& motor) {
    v.number("speed", motor.speed, -limits::max_speed, limits::max_speed);
    v.number("max_torque", motor.max_torque, 0, 1e12);
}
void visit_spring(auto& v, auto& spring) {
    v.number("hertz", spring.hertz, 0, 1e4);
    v.number("damping_ratio", spring.damping_ratio, 0, 1e4);
}

// The order of fields is that of saved worlds: docs/format_changes.md has a line for each change.
template <class Kind>
struct JointFields;

template <>
struct JointFields<BallJoint> {
    static constexpr const char* name = "ball";
    static void visit(auto&, auto&) {}
};

template <>
struct JointFields<HingeJoint> {
    static constexpr const char* name = "hinge";
    static void visit(auto& v, auto& hinge) {
        v.limit("limit", hinge.limit, -pi, pi);
        v.motor("motor", hinge.motor);
        v.spring("spring", hinge.spring);
        v.number("spring_angle", hinge.spring_angle, -pi, pi);
    }
};

template <>
struct JointFields<ConeTwistJoint> {
    static constexpr const char* name = "cone_twist";
    static void visit(auto& v, auto& cone) {
        v.number("swing", cone.swing, 0, pi);
        v.limit("twist", cone.twist, -pi, pi);
        v.number("friction_torque", cone.friction_torque, 0, 1e12);
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

// Calls each(joint) with every kind as its struct makes it, in the order of JointKind.
void for_each_joint_kind(auto&& each) {
    [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
        (each(Kinds{}), ...);
    }(std::type_identity<JointKind>{});
}

}  // namespace jostle::physics
