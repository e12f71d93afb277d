// SPDX-License-Identifier: MIT
//
// Joint definitions. A joint connects a frame in body a with a frame in body b. Its kind determines
// which of the six relative degrees of freedom of the two frames are free, limited, driven or
// locked.
//
// Ranges of fields without a stated range are listed in joint_fields.h.
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

/// A spring on a degree of freedom, specified by its frequency with the effective mass of the two
/// bodies.
struct JointSpring {
    double hertz = 0;          ///< Hz, 0 to 1e4; 0: rigid
    double damping_ratio = 1;  ///< 0 to 1e4; 1: critical damping

    bool operator==(const JointSpring&) const = default;
};

/// Range of an angle or a distance.
struct JointLimit {
    bool enabled = false;         ///< if false, the degree of freedom is unlimited
    double lower = 0, upper = 0;  ///< rad or m, lower <= upper

    bool operator==(const JointLimit&) const = default;
};

/// A motor about an axis.
struct JointMotor {
    bool enabled = false;   ///< if false, the motor exerts no torque
    double speed = 0;       ///< target speed of b relative to a, rad/s, within 1e4
    double max_torque = 0;  ///< N m, 0 to 1e12

    bool operator==(const JointMotor&) const = default;
};

/// A motor along a line.
struct LinearMotor {
    bool enabled = false;  ///< if false, the motor exerts no force
    double speed = 0;      ///< target speed of b relative to a, m/s, within 1e4
    double max_force = 0;  ///< N, 0 to 1e12

    bool operator==(const LinearMotor&) const = default;
};

/// A motor along or about an axis of a SixDofJoint.
struct AxisMotor {
    bool enabled = false;  ///< if false, the motor exerts no force or torque
    double speed = 0;      ///< target speed of b relative to a, m/s or rad/s, within 1e4
    double max_force = 0;  ///< N, or N m for a rotation; 0 to 1e12

    bool operator==(const AxisMotor&) const = default;
};

/// Rotates b's frame relative to a's frame towards a target orientation, like a muscle.
struct RotationDrive {
    JointSpring spring = {};   ///< 0 Hz: no drive
    Quat target = {};          ///< target orientation of b's frame in a's frame
    double max_torque = 1e12;  ///< N m, 0 to 1e12

    bool operator==(const RotationDrive&) const = default;
};

/// Ball joint: the origins of the two frames coincide; rotation is free.
struct BallJoint {
    RotationDrive drive = {};    ///< optional drive to an orientation
    double friction_torque = 0;  ///< N m, resists all rotation; 0 to 1e12

    bool operator==(const BallJoint&) const = default;
};

/// Hinge: b rotates about the common z axis of the two frames. The hinge angle is the angle from
/// a's x axis to b's x axis, in -pi..pi.
struct HingeJoint {
    JointLimit limit = {};         ///< rad, within -pi..pi
    JointMotor motor = {};         ///< drives the angle
    JointSpring spring = {};       ///< pulls the angle towards spring_angle if hertz > 0
    double spring_angle = 0;       ///< rad, within -pi..pi
    double spring_max_torque = 0;  ///< N m, 0 to 1e12; 0: unlimited

    bool operator==(const HingeJoint&) const = default;
};

/// Cone-twist joint, such as a shoulder: b's x axis stays within a cone around a's x axis, and b
/// rotates about its x axis within limits.
struct ConeTwistJoint {
    double swing = 0.5;            ///< half angle of the cone, rad, 0..pi
    JointLimit twist{true, 0, 0};  ///< rotation about the x axis, rad, within -pi..pi
    double friction_torque = 0;    ///< N m, resists all rotation; 0 to 1e12
    RotationDrive drive = {};      ///< optional drive to an orientation

    bool operator==(const ConeTwistJoint&) const = default;
};

/// Fixed joint: the two frames coincide in position and orientation.
struct FixedJoint {
    JointSpring linear = {}, angular = {};  ///< rigid by default

    bool operator==(const FixedJoint&) const = default;
};

/// Distance joint: limits the distance between the origins of the two frames. Rod: min_length ==
/// max_length. Rope: min_length = 0. Spring: hertz > 0 pulls towards rest_length within the limits.
struct DistanceJoint {
    double min_length = 1, max_length = 1;  ///< m, 0 to 1e6, min_length <= max_length
    JointSpring spring = {};                ///< pulls the distance towards rest_length if hertz > 0
    double rest_length = 1;                 ///< m, 0 to 1e6

    bool operator==(const DistanceJoint&) const = default;
};

/// One row of the velocity solver, for custom constraints such as gears, racks, screws, linear
/// motors, dampers and drive trains. With v the velocity of the origin of an end's frame and w the
/// angular velocity of its body, the rate of the row is
///     J = linear_a . v_a + angular_a . w_a + linear_b . v_b + angular_b . w_b
/// and the force f of the row acts on each end along its vectors: linear_a f at the origin of a's
/// frame, angular_a f as a torque, b likewise. A linear motor has linear_a = -linear_b; a gear has
/// angular_b = ratio * angular_a. Units are the user's choice. The solver finds the f within
/// lower..upper that satisfies
///     J + softness f = speed.
struct VelocityRow {
    /// In a's frame or in world axes, each component within 1e6.
    Vec3 linear_a = {}, angular_a = {};
    /// In b's frame or in world axes, each component within 1e6.
    Vec3 linear_b = {}, angular_b = {};
    /// If true, the vectors are world vectors that do not rotate with the bodies.
    bool world_axes = false;
    double speed = 0;  ///< target rate, within 1e9
    /// Corrects a position error: the row moves at speed - bias, and the velocity does not retain
    /// the bias. 0.2 * error / sub-step is a firm correction. World::set_joint() can update it in
    /// each step. Within 1e9.
    double bias = 0;
    double softness = 0;                 ///< rate per force, 0 to 1e9; 0: rigid, 1 / c for a damper
    double lower = -1e15, upper = 1e15;  ///< bounds of the force, within 1e15, lower <= upper

    bool operator==(const VelocityRow&) const = default;
};

/// Slider: b slides along the z axis of a's frame and does not rotate relative to it. The travel is
/// the position of b's origin along that axis.
struct SliderJoint {
    JointLimit limit = {};        ///< of the travel, m, within -1e6..1e6
    LinearMotor motor = {};       ///< drives the travel
    JointSpring spring = {};      ///< pulls the travel towards spring_travel if hertz > 0
    double spring_travel = 0;     ///< m, within 1e6
    double friction_force = 0;    ///< N, resists sliding; 0 to 1e12
    double spring_max_force = 0;  ///< N, 0 to 1e12; 0: unlimited

    bool operator==(const SliderJoint&) const = default;
};

/// One of the six relative degrees of freedom of two frames. Locked unless `free` is set. A locked
/// axis has no limit, spring, motor or friction.
struct JointAxis {
    bool free = false;         ///< whether the axis is free
    JointLimit limit = {};     ///< m or rad
    JointSpring spring = {};   ///< pulls the coordinate towards spring_target if hertz > 0
    double spring_target = 0;  ///< rest position of the spring, m or rad
    AxisMotor motor = {};      ///< drives the coordinate
    double friction = 0;       ///< N or N m, resists motion along or about the axis; 0 to 1e12
    /// Maximum force of the spring, N, or N m for a rotation; 0 to 1e12; 0: unlimited.
    double spring_max_force = 0;

    bool operator==(const JointAxis&) const = default;
};

/// The axes of a six-degree-of-freedom joint: three translations and three rotations.
///
/// Translations are those of b's origin along the axes of a's frame. Rotations are successive
/// angles, as in a gimbal: the first is about an axis of a's frame, the last about an axis of b's
/// frame, and the middle one is perpendicular to both. The middle rotation is the first locked one
/// among y, z, x, or y if all are free. The others precede and follow it in the order x y z x y. A
/// single free rotation is therefore unbounded, and each of two free rotations is about an axis of
/// its own body, as in a universal joint. A free middle rotation stays within -pi/2..pi/2.
struct SixDofAxes {
    JointAxis x, y, z;                             ///< translations, m, within 1e6
    JointAxis rotation_x, rotation_y, rotation_z;  ///< rotations, rad, within -pi..pi

    bool operator==(const SixDofAxes&) const = default;
};
/// Six-degree-of-freedom joint: every axis can be free, limited, driven or locked.
struct SixDofJoint {
    Boxed<SixDofAxes> axes;  ///< on the heap, because it is much larger than the other kinds

    bool operator==(const SixDofJoint&) const = default;
};

/// Wheel joint: the wheel b moves along the y axis of a's frame (suspension), is steered about that
/// axis, and spins about the z axis of b's frame, which stays perpendicular to it.
struct WheelJoint {
    JointSpring suspension = {};  ///< pulls the travel towards suspension_target if hertz > 0
    /// Rest position of the suspension spring, m along the suspension, within 1e6.
    double suspension_target = 0;
    JointLimit travel = {};  ///< m along the suspension, within -1e6..1e6
    double steering = 0;  ///< rad, within -pi..pi; held at this angle unless free_steering is set
    bool free_steering = false;      ///< whether the wheel steers freely, as a castor
    JointLimit steering_limit = {};  ///< rad, within -pi..pi; used with free_steering
    JointMotor motor = {};           ///< spins the wheel
    double friction_torque = 0;      ///< N m, resists spin (bearings, brakes); 0 to 1e12

    bool operator==(const WheelJoint&) const = default;
};

/// Grab joint: pulls the origin of b's frame to a target, usually with the world as body a.
struct GrabJoint {
    Vec3 target = {};            ///< m, in a's frame; each component within 1e6
    JointSpring spring = {};     ///< 0 Hz: no pull
    double max_force = 1e15;     ///< N, 0 to 1e15
    double angular_damping = 0;  ///< 1/s, 0 to 1e6: damping of b's rotation relative to a

    bool operator==(const GrabJoint&) const = default;
};

/// Gear joint: couples the rotation of two bodies, each about the z axis of its frame. turn_a +
/// ratio * turn_b keeps the value that it had at creation, over any number of revolutions. The
/// angle of each body is measured relative to its carrier: the body to which a hinge or wheel joint
/// along the same axis connects it, of several joints the one created first, or the world if there
/// is none. Carriers receive the reaction torques.
struct GearJoint {
    /// Of b's rotation, -1e6..1e6; 2: b rotates half as fast, in the opposite sense.
    double ratio = 1;

    bool operator==(const GearJoint&) const = default;
};

/// Rack and pinion: the pinion a rotates about the z axis of its frame, and the rack b moves along
/// the z axis of its frame. travel_b - radius * turn_a keeps the value that it had at creation. The
/// carrier of a is that of a gear; the carrier of b is the body to which a slider along the same
/// axis connects it.
struct RackJoint {
    double radius = 1;  ///< m of b's travel per rad of a's rotation, -1e6..1e6

    bool operator==(const RackJoint&) const = default;
};

/// Pulley: a rope from the origin of a's frame to a fixed world point, over to another world point,
/// and to the origin of b's frame. length_a + ratio * length_b is at most `length`. With a ratio of
/// 2 the rope runs twice between b and its point, as in a block and tackle.
struct PulleyJoint {
    Vec3 point_a = {}, point_b = {};  ///< m, world; each component within 1e6
    double length = 1;                ///< m, 0..1e6
    double ratio = 1;                 ///< 1e-3..1e3

    bool operator==(const PulleyJoint&) const = default;
};

/// Path joint: the origin of b's frame stays on a curve through points in a's frame, and b rotates
/// freely. The travel is the arc length of the curve from its start.
struct PathJoint {
    /// m, 2..1024 points, each component within 1e6, adjacent points at least 1e-6 m apart.
    std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 1}};
    bool smooth = true;  ///< Catmull-Rom spline if true, polyline if false
    /// Whether the curve returns to the first point; the travel then wraps around.
    bool closed = false;
    /// m of travel, within 0..1e9; open paths only, whose ends are limits too.
    JointLimit limit = {};
    LinearMotor motor = {};     ///< drives the travel
    JointSpring spring = {};    ///< pulls the travel towards spring_travel if hertz > 0
    double spring_travel = 0;   ///< m, 0..1e9
    double friction_force = 0;  ///< N, resists sliding; 0 to 1e12

    bool operator==(const PathJoint&) const = default;
};

/// The kind of a joint with its parameters.
using JointKind = std::variant<BallJoint, HingeJoint, ConeTwistJoint, FixedJoint, DistanceJoint,
                               VelocityRow, SliderJoint, SixDofJoint, WheelJoint, GrabJoint,
                               GearJoint, RackJoint, PulleyJoint, PathJoint>;
/// Number of joint kinds.
inline constexpr int joint_kinds = static_cast<int>(std::variant_size_v<JointKind>);
/// Returns the name of a kind: "ball", "hinge", "cone-twist". The string has static storage
/// duration.
const char* kind_name(const JointKind& kind);

/// Description of a joint for World::create_joint().
struct JointDef {
    /// The connected bodies; at least one is dynamic. A null body_a is the world; frame_a is then a
    /// world frame.
    BodyId body_a = {}, body_b = {};
    Transform frame_a = {}, frame_b = {};  ///< in the local frames of the bodies
    JointKind kind = BallJoint{};          ///< the kind and its parameters
    bool collide_connected = false;  ///< whether shapes of the two bodies collide with each other
    double break_force = 0;          ///< N, 0 to 1e15; 0: unbreakable
    double break_torque = 0;         ///< N m, 0 to 1e15; 0: unbreakable
    std::uint64_t user_data = 0;     ///< stored, saved and returned, not interpreted
    /// Solver of the joint and its group (joint_solver.h). Empty: WorldDef::joint_solver.
    std::optional<JointSolver> solver = {};
};

/// The current state of a joint (World::joint).
struct JointState {
    JointId id = {};   ///< the joint
    JointDef def;      ///< description with the current parameters
    Vec3 force = {};   ///< force on b, N, world; mean of the last step
    Vec3 torque = {};  ///< torque on b, N m, world; mean of the last step
    /// rad; hinge angle, twist of a cone-twist joint, spin of a wheel. Within half a turn of the
    /// middle of its limits, otherwise -pi..pi.
    double angle = 0;
    double swing = 0;  ///< rad; swing of a cone-twist joint
    /// Distance between the origins of the frames, in m. Distance joint: the current length. Path
    /// joint: the distance from the curve.
    double separation = 0;
    /// Travel in m. Slider and wheel: along the axis. Path: along the curve to b. Pulley: rope in
    /// use.
    double travel = 0;
    /// Rotation angles in rad. Six-dof: about each axis, as defined by SixDofAxes. Wheel: y is the
    /// steering, z the spin.
    Vec3 angles = {};
    Vec3 offset = {};  ///< position of b's origin relative to a's origin, in a's frame, m
};

}  // namespace jostle::physics
