// SPDX-License-Identifier: MIT
//
// Joints: what holds two bodies together. Each end has a frame in its body; the kind says which of
// the six relative degrees of freedom of the two frames are free, limited, driven or locked. What
// values the fields of a kind may have says joint_fields.h.
#pragma once

#include <cstdint>
#include <variant>

#include "jostle/physics/ids.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

// A spring on a degree of freedom, by its frequency against the two bodies' own masses.
struct JointSpring {
    double hertz = 0;  // 0: rigid
    double damping_ratio = 1;

    bool operator==(const JointSpring&) const = default;
};

// A range of an angle or a distance.
struct JointLimit {
    bool enabled = false;
    double lower = 0, upper = 0;  // rad or m, lower <= upper

    bool operator==(const JointLimit&) const = default;
};

struct JointMotor {
    bool enabled = false;
    double speed = 0;       // rad/s of b against a
    double max_torque = 0;  // N m

    bool operator==(const JointMotor&) const = default;
};

// The origins of both frames stay together.
struct BallJoint {
    bool operator==(const BallJoint&) const = default;
};

// Turns about the frames' common z axis. The angle is that of b's x axis against a's, in -pi..pi.
struct HingeJoint {
    JointLimit limit = {};  // rad, within -pi..pi
    JointMotor motor = {};
    JointSpring spring = {};  // pulls the angle towards spring_angle when hertz > 0
    double spring_angle = 0;  // rad

    bool operator==(const HingeJoint&) const = default;
};

// A shoulder: b's x axis stays in a cone about a's x axis, and b turns about it within limits.
struct ConeTwistJoint {
    double swing = 0.5;            // rad, half angle of the cone, 0..pi
    JointLimit twist{true, 0, 0};  // rad, within -pi..pi
    double friction_torque = 0;    // N m that resists all turning

    bool operator==(const ConeTwistJoint&) const = default;
};

// The frames stay together in full.
struct FixedJoint {
    JointSpring linear = {}, angular = {};  // rigid by default

    bool operator==(const FixedJoint&) const = default;
};

// The distance of the two frames' origins. Rod: min == max. Rope: min = 0. Spring: hertz > 0, pulls
// towards rest_length between the two limits.
struct DistanceJoint {
    double min_length = 1, max_length = 1;  // m
    JointSpring spring = {};
    double rest_length = 1;  // m

    bool operator==(const DistanceJoint&) const = default;
};

// One row of the velocity solver, for what no other kind does: gears, racks, screws, motors along a
// line, dampers, a vehicle's drive train. With v the velocity of an end's frame origin and w that
// of its rotation, the row's rate is
//     J = linear_a . v_a + angular_a . w_a + linear_b . v_b + angular_b . w_b
// and the row's force f pushes each end along its vectors: linear_a f at a's frame origin,
// angular_a f about it, b likewise. A motor along a line or a gear is linear_a = -linear_b or
// angular_b = ratio * angular_a; units are the user's. The solver finds the f within lower..upper
// that makes
//     J + softness f = speed.
struct VelocityRow {
    Vec3 linear_a = {}, angular_a = {};  // in a's frame, or in the world's axes
    Vec3 linear_b = {}, angular_b = {};  // in b's frame, or in the world's axes
    bool world_axes = false;  // the vectors are the world's and do not turn with the bodies
    double speed = 0;
    // Mends an error of position: the row moves at speed - bias, and keeps none of the bias as
    // velocity. 0.2 * error / sub-step is firm; World::set_joint() may give a new one each step.
    double bias = 0;
    double softness = 0;                 // rate per force, >= 0; 0: rigid. A damper's is 1 / c
    double lower = -1e15, upper = 1e15;  // of the force

    bool operator==(const VelocityRow&) const = default;
};

using JointKind =
    std::variant<BallJoint, HingeJoint, ConeTwistJoint, FixedJoint, DistanceJoint, VelocityRow>;
inline constexpr int joint_kinds = static_cast<int>(std::variant_size_v<JointKind>);
const char* kind_name(const JointKind& kind);  // "ball", "hinge", "cone-twist", ...

struct JointDef {
    BodyId body_a = {}, body_b = {};       // at least one of them dynamic
    Transform frame_a = {}, frame_b = {};  // in the bodies' own frames
    JointKind kind = BallJoint{};
    bool collide_connected = false;  // whether the two bodies' shapes collide with each other
    double break_force = 0;          // N; 0: never breaks
    double break_torque = 0;         // N m; 0: never breaks
    std::uint64_t user_data = 0;
};

struct JointState {
    JointId id = {};
    JointDef def;
    Vec3 force = {};        // N on b, world, mean of the last step
    Vec3 torque = {};       // N m on b, world
    double angle = 0;       // hinge: rad; cone-twist: rad of twist
    double swing = 0;       // cone-twist: rad
    double separation = 0;  // m between the frames' origins; distance: the present length
};

}  // namespace jostle::physics
