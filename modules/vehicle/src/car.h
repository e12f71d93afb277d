// SPDX-License-Identifier: MIT
//
// A car: its definition, its saved state, and values that are valid for one step and are not saved.
#pragma once

#include <array>
#include <vector>

#include "jostle/modules/vehicle.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/transform.h"

namespace jostle::modules::vehicle_detail {

using physics::Mat3;
using physics::Quat;
using physics::ShapeId;
using physics::Transform;

// Source of the controls.
enum class Driver : std::uint8_t { none, pilot, player };

// State of a wheel; saved.
struct WheelRuntime {
    double stiffness = 0, damping = 0;                           // of the suspension: N/m, N s/m
    double spin = 0, angle = 0;                                  // rad/s, rad
    double longitudinal_deflection = 0, lateral_deflection = 0;  // m, deflection of the tread
    double travel = 0;                                           // m
    double load = 0, forward = 0, lateral = 0;                   // N
    double friction = 0;                                         // combined with the ground
    bool touches = false;
    BodyId ground = {};
    ShapeId shape = {};
    Vec3 point = {}, normal = {0, 1, 0};
};

// State of a wheel that is a body; saved.
struct WheelBody {
    BodyId body = {};
    physics::JointId joint = {};
    double spin = 0;           // rad/s, forward, at the last sub-step
    double drive_impulse = 0;  // N m s, applied by the drive line in that sub-step
    double resistance = 0;     // N m, estimated torque of ground and brakes against the rotation
};

// The ground under a wheel, valid for one step.
struct Ground {
    bool found = false;
    bool dynamic = false;  // receives the reaction
    Vec3 point = {}, normal = {};
    Vec3 velocity = {};       // m/s, at the point
    double reach = 0;         // m, from the plane to the wheel's centre in contact
    double inverse_mass = 0;  // 1/kg, seen by a tyre force along the ground; 0 if not computed yet
    Vec3 reaction_impulse = {};  // N s, reaction that is due at the end of the step
};

// Axes of a wheel from definition and controls, valid for one step.
struct WheelAxes {
    Vec3 down = {}, axle = {}, forward = {};  // in the chassis frame, steered
};

// Lean of a two-wheeler at the start of a step.
struct Lean {
    bool touching = false;
    double angle = 0, rate = 0;  // rad, rad/s, positive to the right
    double height = 1;           // m, length of the equivalent pendulum
    double weight = 9.81;        // m/s^2, downwards
    double inertia = 0;          // kg m^2, about the line of contact
    double own_inertia = 1;      // kg m^2, about the centre of mass, along the forward axis
    double yaw_rate = 0;         // rad/s, positive to the right
    double front_heading = 0;  // rad, positive to the right: direction of motion of the front wheel
};

// State of a brake, clutch or coupling.
enum class FrictionState : std::uint8_t { sticking, slipping_forward, slipping_backward };

struct Car {
    CarId id = 0;
    VehicleDef def;
    CarControls controls;
    Driver driver = Driver::none;
    Pilot pilot;
    double driver_steering = 0, driver_throttle = 0;  // driver input, -1 to 1
    std::uint32_t driver_buttons = 0;

    std::vector<WheelRuntime> wheels;
    std::vector<WheelBody> bodies;  // one per wheel, or empty
    double steering = 0;            // -1 to 1, follows the controls
    double engine_speed = 0;
    double engine_torque = 0, clutch_torque = 0;
    std::int32_t gear = 0;
    double shift_left = 0, pause_left = 0;  // s
    double speed = 0;                       // m/s, forward
    // Estimate of other accelerations of the chassis, from the difference to the velocity expected
    // after the last sub-step.
    bool has_expected_motion = false;
    Vec3 expected_v = {}, expected_w = {};
    Vec3 external_acceleration = {}, external_angular_acceleration = {};
    bool supported = false;  // wheels carry the chassis

    // Valid for one step.
    bool active = false;
    Vec3 support_impulse = {};  // N s per sub-step
    double mass = 0;
    double external_acceleration_max = 100;  // m/s^2 and rad/s^2, limit of the estimate
    Mat3 inverse_inertia;                    // world axes
    std::vector<Ground> grounds;
    std::vector<WheelAxes> wheel_axes;
    Lean lean;
};

// Motion of the chassis in a sub-step.
struct ChassisFrame {
    Transform pose = {};
    Mat3 axes;
    Vec3 center = {}, v = {}, w = {};
    Vec3 next_v = {}, next_w = {};  // at the end of the sub-step without forces of the car
    double h = 0;                   // s
    double time = 0;                // s since the start of the step
};

// Response of a tread at a load, in a sub-step.
struct TreadState {
    double limit;  // N: friction * load
    // Normalized deflection s per metre: C / (3 mu length)
    double longitudinal_deflection, lateral_deflection;
    double roll;           // fraction of the deflection left after a sub-step
    double rolling_share;  // 0 at standstill, 1 from 1 m/s
    double longitudinal_damping, lateral_damping;  // N s/m, at standstill
    // N per m of deflection, secant at the current deflection
    double longitudinal_secant, lateral_secant;
};

// A wheel in contact with the ground, in a sub-step. find_contacts(), solve_loads() and drive()
// fill it in that order. It is not zeroed first, which would cost as much as the solve.
struct Contact {
    std::uint32_t wheel;
    Vec3 arm;                       // m, from the centre of mass
    Vec3 normal, forward, lateral;  // unit
    Vec3 velocity;                  // m/s, of the chassis at the contact, relative to the ground
    double longitudinal_velocity, lateral_velocity;
    double pressed;       // m, compression
    double lever;         // suspension travel per motion along the normal
    double inverse_mass;  // 1/kg, seen by a tyre force along the ground
    double load;          // N
    TreadState tread;
    double longitudinal_force, lateral_force;  // N
};

struct Contacts {
    // A union avoids the zero-initialization of the Vec3 members.
    union {
        std::array<Contact, wheels_max> all;
    };
    std::size_t count = 0;

    Contacts() {}
    Contact* begin() { return all.data(); }
    Contact* end() { return all.data() + count; }
};

// rad, the largest steering angle of any wheel.
inline double full_lock(const VehicleDef& def) {
    double most = 0.01;
    for (const Wheel& wheel : def.wheels) most = physics::maximum(most, wheel.max_steering_angle);
    return most;
}

}  // namespace jostle::modules::vehicle_detail
