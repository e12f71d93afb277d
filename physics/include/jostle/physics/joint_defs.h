// SPDX-License-Identifier: MIT
//
// Joints: what holds two bodies together. Each end has a frame in its body; the kind says which of
// the six relative degrees of freedom of the two frames are free, limited, driven or locked. What
// values the fields of a kind may have says joint_fields.h.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "jostle/physics/boxed.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/joint_solver.h"
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

// Along a line.
struct LinearMotor {
    bool enabled = false;
    double speed = 0;      // m/s of b against a
    double max_force = 0;  // N

    bool operator==(const LinearMotor&) const = default;
};

// Along or about an axis.
struct AxisMotor {
    bool enabled = false;
    double speed = 0;  // m/s or rad/s of b against a
    double most = 0;   // N or N m

    bool operator==(const AxisMotor&) const = default;
};

// Turns b's frame against a's to an orientation, as muscles would.
struct RotationDrive {
    JointSpring spring = {};   // 0 hertz: no drive
    Quat target = {};          // of b's frame in a's
    double max_torque = 1e12;  // N m

    bool operator==(const RotationDrive&) const = default;
};

// The origins of both frames stay together.
struct BallJoint {
    RotationDrive drive = {};
    double friction_torque = 0;  // N m that resists all turning

    bool operator==(const BallJoint&) const = default;
};

// Turns about the frames' common z axis. The angle is that of b's x axis against a's, in -pi..pi.
struct HingeJoint {
    JointLimit limit = {};  // rad, within -pi..pi
    JointMotor motor = {};
    JointSpring spring = {};       // pulls the angle towards spring_angle when hertz > 0
    double spring_angle = 0;       // rad
    double spring_max_torque = 0;  // N m; 0: as much as the spring asks for

    bool operator==(const HingeJoint&) const = default;
};

// A shoulder: b's x axis stays in a cone about a's x axis, and b turns about it within limits.
struct ConeTwistJoint {
    double swing = 0.5;            // rad, half angle of the cone, 0..pi
    JointLimit twist{true, 0, 0};  // rad, within -pi..pi
    double friction_torque = 0;    // N m that resists all turning
    RotationDrive drive = {};

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

// b slides along the z axis of a's frame and does not turn against it. Its travel is how far b's
// origin is along that axis.
struct SliderJoint {
    JointLimit limit = {};  // m, within -1e6..1e6
    LinearMotor motor = {};
    JointSpring spring = {};      // pulls the travel towards spring_travel when hertz > 0
    double spring_travel = 0;     // m
    double friction_force = 0;    // N that resists sliding
    double spring_max_force = 0;  // N; 0: as much as the spring asks for

    bool operator==(const SliderJoint&) const = default;
};

// One of the six relative degrees of freedom of two frames. Locked unless free; what is locked has
// nothing else.
struct JointAxis {
    bool free = false;
    JointLimit limit = {};  // m or rad
    JointSpring spring = {};
    double spring_at = 0;  // m or rad: where the spring pulls to
    AxisMotor motor = {};
    double friction = 0;     // N or N m that resists
    double spring_most = 0;  // N or N m; 0: as much as the spring asks for

    bool operator==(const JointAxis&) const = default;
};

// Each of three translations and three turns by itself. The translations are those of b's origin
// along the axes of a's frame. The turns are angles one after the other, like those of a gimbal:
// the first is about an axis of a's frame, the last about one of b's frame, the middle one across
// both. The middle one is the first locked turn among y, z, x, or y when all are free; before and
// after it come the others, in the order x y z x y. So a lone free turn goes all the way round, and
// of two free ones each is about an axis of its own body, as in a universal joint. A middle turn
// that is free stays within a quarter turn each way.
struct SixDofAxes {
    JointAxis x, y, z;                 // m
    JointAxis turn_x, turn_y, turn_z;  // rad, within -pi..pi

    bool operator==(const SixDofAxes&) const = default;
};
struct SixDofJoint {
    Boxed<SixDofAxes> axes;  // large: a joint of another kind does not carry it along

    bool operator==(const SixDofJoint&) const = default;
};

// The wheel b on the chassis a: it rises and falls along the y axis of a's frame, is steered about
// that axis, and spins about the z axis of b's frame, which stays across it.
struct WheelJoint {
    JointSpring suspension = {};
    double ride = 0;         // m along the suspension, where its spring is at rest
    JointLimit travel = {};  // m along the suspension, within -1e6..1e6
    double steering = 0;  // rad, within -pi..pi: the wheel is held there, unless it steers freely
    bool free_steering = false;      // as a castor does
    JointLimit steering_limit = {};  // rad, of a castor, within -pi..pi
    JointMotor motor = {};           // spins the wheel
    double friction_torque = 0;      // N m that resists spin: bearings, brakes

    bool operator==(const WheelJoint&) const = default;
};

// A hand: pulls the origin of b's frame to a target, mostly with the world as a.
struct GrabJoint {
    Vec3 target = {};         // m, in a's frame; each component within 1e6
    JointSpring spring = {};  // 0 hertz: does not pull
    double max_force = 1e15;  // N
    double turn_damping = 0;  // 1/s: b loses that share of its spin against a

    bool operator==(const GrabJoint&) const = default;
};

// Couples two bodies that turn, each about the z axis of its frame, as gears do: turn_a + ratio *
// turn_b stays what it was when the joint was made, however often they go round. A turn is against
// the carrier: what a hinge or a wheel along the same axis holds the body to, of several the one
// made first; the world if there is none. Carriers feel what gears do to each other.
struct GearJoint {
    double ratio = 1;  // of b's turn, -1e6..1e6; 2: b turns half as fast, the other way

    bool operator==(const GearJoint&) const = default;
};

// The pinion a, which turns about the z axis of its frame, and the rack b, which moves along the z
// axis of its frame: travel_b - radius * turn_a stays what it was when the joint was made. a's
// carrier is that of a gear; b's is what a slider along the same axis holds it to.
struct RackJoint {
    double radius = 1;  // m of b's travel for each rad of a's turn, -1e6..1e6

    bool operator==(const RackJoint&) const = default;
};

// A rope from the origin of a's frame up to a point of the world, over to another, and down to the
// origin of b's frame: length_a + ratio * length_b is at most `length`. With a ratio of 2 the rope
// goes up and down at b, as in a tackle.
struct PulleyJoint {
    Vec3 point_a = {}, point_b = {};  // m, world; each component within 1e6
    double length = 1;                // m, 0..1e6
    double ratio = 1;                 // 1e-3..1e3

    bool operator==(const PulleyJoint&) const = default;
};

// A bead on a wire: the origin of b's frame stays on a curve through points in a's frame, and b
// turns freely. Its travel is the length of the curve up to it.
struct PathJoint {
    std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 1}};  // m, 2..1024, each component within 1e6
    bool smooth = true;     // Catmull-Rom; else straight from point to point
    bool closed = false;    // from the last point back to the first; its travel starts again there
    JointLimit limit = {};  // m of travel, of an open path, within 0..1e9; its ends are limits, too
    LinearMotor motor = {};
    JointSpring spring = {};    // pulls the travel towards spring_travel when hertz > 0
    double spring_travel = 0;   // m, 0..1e9
    double friction_force = 0;  // N that resists sliding

    bool operator==(const PathJoint&) const = default;
};

using JointKind = std::variant<BallJoint, HingeJoint, ConeTwistJoint, FixedJoint, DistanceJoint,
                               VelocityRow, SliderJoint, SixDofJoint, WheelJoint, GrabJoint,
                               GearJoint, RackJoint, PulleyJoint, PathJoint>;
inline constexpr int joint_kinds = static_cast<int>(std::variant_size_v<JointKind>);
const char* kind_name(const JointKind& kind);  // "ball", "hinge", "cone-twist", ...

struct JointDef {
    // At least one of them dynamic. A null body_a is the world, and frame_a is a frame in it.
    BodyId body_a = {}, body_b = {};
    Transform frame_a = {}, frame_b = {};  // in the bodies' own frames
    JointKind kind = BallJoint{};
    bool collide_connected = false;  // whether the two bodies' shapes collide with each other
    double break_force = 0;          // N; 0: never breaks
    double break_torque = 0;         // N m; 0: never breaks
    std::uint64_t user_data = 0;
    // How it is solved, and what it shares a group with; empty: as WorldDef::joint_solver says.
    std::optional<JointSolver> solver = {};
};

struct JointState {
    JointId id = {};
    JointDef def;
    Vec3 force = {};   // N on b, world, mean of the last step
    Vec3 torque = {};  // N m on b, world
    double angle = 0;  // hinge: rad; cone-twist: rad of twist; wheel: rad of spin
    double swing = 0;  // cone-twist: rad
    // m between the frames' origins; distance: the present length; path: from the curve.
    double separation = 0;
    double travel = 0;  // slider, wheel: m along the axis; path: m up to b;
                        // pulley: m of rope in use
    // Six-dof: rad about each axis, as SixDofAxes says. Wheel: y is the steering.
    Vec3 angles = {};
    Vec3 offset = {};  // of b's origin from a's, in a's frame, m
};

}  // namespace jostle::physics
