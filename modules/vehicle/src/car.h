// SPDX-License-Identifier: MIT
//
// One car: what it is made of, its state, which is saved, and what holds for one step, which is
// not.
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

// Who decides on the controls.
enum class Driver : std::uint8_t { none, pilot, player };

// Saved.
struct WheelRuntime {
    double stiffness = 0, damping = 0;  // of the suspension: N/m, N s/m
    double spin = 0, angle = 0;         // rad/s, rad
    double longitudinal_deflection = 0,
           lateral_deflection = 0;              // m that the tread is bent: pushes the chassis so
    double travel = 0;                          // m
    double load = 0, forward = 0, lateral = 0;  // N
    double friction = 0;                        // with the ground
    bool touches = false;
    BodyId ground = {};
    ShapeId shape = {};
    Vec3 point = {}, normal = {0, 1, 0};
};

// A wheel that is a body: saved.
struct WheelBody {
    BodyId body = {};
    physics::JointId joint = {};
    double spin = 0;           // rad/s ahead at the last sub-step
    double drive_impulse = 0;  // N m s that it was given then
    double resistance = 0;     // N m that ground and brakes turn it by: learned
};

// The ground under a wheel, for a step.
struct Ground {
    bool found = false;
    bool dynamic = false;  // is pushed back
    Vec3 point = {}, normal = {};
    Vec3 velocity = {};          // m/s, there
    double reach = 0;            // m from the plane to the wheel's centre when it touches
    double inverse_mass = 0;     // 1/kg that a tyre meets along the ground; 0: not asked yet
    Vec3 reaction_impulse = {};  // N s: what it is owed at the end of the step
};

// What follows from the definition and the controls, for a step.
struct WheelAxes {
    Vec3 down = {}, axle = {}, forward = {};  // in the chassis, steered
};

// Of a two-wheeler, at the start of the step.
struct Lean {
    bool touching = false;
    double angle = 0, rate = 0;  // rad, rad/s, to the right
    double height = 1;           // m: of a pendulum that falls as fast
    double weight = 9.81;        // m/s^2 down
    double inertia = 0;          // kg m^2 about the line that it leans over
    double own_inertia = 1;      // kg m^2 about its centre of mass, along its way
    double yaw_rate = 0;         // rad/s to the right
    double front_heading = 0;    // rad to the right: where the front wheel goes
};

enum class FrictionState : std::uint8_t {
    sticking,
    slipping_forward,
    slipping_backward
};  // of a brake, clutch, coupling

struct Car {
    CarId id = 0;
    VehicleDef def;
    CarControls controls;
    Driver driver = Driver::none;
    Pilot pilot;
    double driver_steering = 0, driver_throttle = 0;  // what a person holds, -1 to 1
    std::uint32_t driver_buttons = 0;

    std::vector<WheelRuntime> wheels;
    std::vector<WheelBody> bodies;  // as many, or none
    double steering = 0;            // -1 to 1, follows the controls
    double engine_speed = 0;
    double engine_torque = 0, clutch_torque = 0;
    std::int32_t gear = 0;
    double shift_left = 0, pause_left = 0;  // s
    double speed = 0;                       // m/s ahead
    // What else pushes the chassis: found from where it was expected after the last sub-step.
    bool has_expected_motion = false;
    Vec3 expected_v = {}, expected_w = {};
    Vec3 external_acceleration = {}, external_angular_acceleration = {};
    bool supported = false;  // wheels bear it

    // Of the step.
    bool active = false;
    Vec3 support_impulse = {};  // N s of each sub-step
    double mass = 0;
    double external_acceleration_max = 100;  // m/s^2, rad/s^2 that are learned
    Mat3 inverse_inertia;                    // world axes
    std::vector<Ground> grounds;
    std::vector<WheelAxes> wheel_axes;
    Lean lean;
};

// The chassis in a sub-step.
struct ChassisFrame {
    Transform pose = {};
    Mat3 axes;
    Vec3 center = {}, v = {}, w = {};
    Vec3 next_v = {}, next_w = {};  // at the sub-step's end, if the car does not push
    double h = 0;                   // s
    double time = 0;                // s since the step began
};

// How a tread pushes at a load, in a sub-step.
struct TreadState {
    double limit;                                        // N: friction * load
    double longitudinal_deflection, lateral_deflection;  // s per m of bend: C / (3 mu length)
    double roll;                                         // share of its bend that a sub-step leaves
    double rolling_share;                                // 0 at standstill, 1 from 1 m/s on
    double longitudinal_damping, lateral_damping;        // N s/m, at standstill
    double longitudinal_secant, lateral_secant;          // N per m of bend, as it is bent
};

// A wheel that touches, in a sub-step. Step by step filled in by find_contacts(), solve_loads(),
// and drive(); not cleared before, which would cost as much as the solve.
struct Contact {
    std::uint32_t wheel;
    Vec3 arm;                       // m from the centre of mass
    Vec3 normal, forward, lateral;  // unit
    Vec3 velocity;                  // m/s of the chassis there, against the ground
    double longitudinal_velocity, lateral_velocity;
    double pressed;       // m
    double lever;         // suspension travel per motion along the normal
    double inverse_mass;  // 1/kg that a tyre meets along the ground
    double load;          // N
    TreadState tread;
    double longitudinal_force, lateral_force;  // N
};

struct Contacts {
    // Not the Vec3s' zeros either.
    union {
        std::array<Contact, wheels_max> all;
    };
    std::size_t count = 0;

    Contacts() {}
    Contact* begin() { return all.data(); }
    Contact* end() { return all.data() + count; }
};

// rad: as far as one of its wheels turns.
inline double full_lock(const VehicleDef& def) {
    double most = 0.01;
    for (const Wheel& wheel : def.wheels) most = physics::maximum(most, wheel.steering_most);
    return most;
}

}  // namespace jostle::modules::vehicle_detail
