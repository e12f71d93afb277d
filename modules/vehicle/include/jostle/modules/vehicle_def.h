// SPDX-License-Identifier: MIT
//
// What a car is made of, with defaults that drive: a saloon of 1,500 kg. Units are SI; a value out
// of its range is refused with an Error that names it. In the chassis body's frame y is up, -z
// ahead and x right.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

using physics::BodyId;
using physics::Vec3;

inline constexpr std::size_t wheels_max = 16;              // of a car
inline constexpr std::size_t differential_locks_max = 16;  // of a car: differentials that lock
inline constexpr std::size_t anti_roll_bars_max = 6;       // anti-roll
inline constexpr std::size_t curve_points_max = 16;
inline constexpr std::size_t gears_max = 12;  // ahead

// How a wheel finds the ground: by looking for it once a step along its suspension, where the plane
// that it finds holds for the step; or as a body that touches what it touches.
enum class WheelCast : std::uint8_t {
    ray,       // of the wheel's middle: the cheapest, and falls into every gap
    sphere,    // of the wheel's radius
    cylinder,  // the wheel as it is: climbs kerbs
    // Each wheel is a cylinder of `mass` on a wheel joint of the solver, which springs, steers and
    // brakes it. It holds by Coulomb friction, has the inertia of a full cylinder, and stops at
    // both ends of its suspension. Not for two-wheelers. It may turn by 0.3 rad in a sub-step, 45
    // m/s for 0.33 m at 480 sub-steps a second: beyond it the solver does not keep it straight.
    body,
};

// A brush tyre with relaxation (Pacejka, "Tire and vehicle dynamics", 3rd edition, chapters 3.2 and
// 7): the tread is bent by what the contact patch slips against the ground, at most as far as
// friction holds, along and aside together.
struct Tyre {
    // Coulomb coefficient, 0 to 10; with the ground's friction by the rule of materials (Combine).
    double friction = 1;
    physics::Combine friction_rule = physics::Combine::geometric_mean;
    double longitudinal_stiffness = 20;  // force per load and slip, 1 to 100
    double cornering_stiffness = 15;     // force per load and rad of slip angle, 1 to 100
    double relaxation_length = 0.3;      // m rolled until the force has come, 0.02 to 3
    double damping = 0.5;                // of the tread at standstill, of critical, 0 to 2
    double rolling_resistance = 0.012;   // force per load, 0 to 0.5
};

struct Suspension {
    // m from the attachment to the wheel's centre: pressed in fully, and hanging.
    double shortest = 0.1, longest = 0.45;  // -10 to 10; shortest < longest
    // Of the mass that rests on this wheel, bouncing on it: stiffness = mass (2 pi frequency)^2.
    double frequency = 1.5;  // Hz, 0.1 to 100
    double damping = 0.3;    // of critical, 0 to 10
    // N that the spring bears at its longest, 0 to 1e7.
    double preload = 0;
};

struct Wheel {
    Vec3 attachment = {};    // m, in the chassis; within 100
    Vec3 down = {0, -1, 0};  // along the suspension; not zero, made unit
    Vec3 axle = {1, 0, 0};   // to the right when it steers straight; square to `down`
    double radius = 0.33;    // m, 0.02 to 10
    double width = 0.22;     // m, 0.01 to 10
    double inertia = 1.2;    // kg m^2 about the axle, 0.001 to 1e5
    double mass = 20;        // kg of a wheel that is a body, 0.01 to 1e6; else in the chassis
    Suspension suspension = {};
    Tyre tyre = {};
    double steering_most = 0;      // rad at full lock, -1.4 to 1.4; below 0: turns the other way
    double drive_share = 0;        // of the gearbox's torque, 0 to 1; of all wheels 0 or 1 in sum
    double brake_torque = 1500;    // N m at full brake, 0 to 1e7
    double hand_brake_torque = 0;  // N m, 0 to 1e7
    // N m at full lock, -1e7 to 1e7: brakes when it is steered to the right, below 0 to the left.
    // So tracks turn.
    double steering_brake = 0;
    // m, 0 to the radius: how round the tread is across. A round one rolls over to its side when
    // the wheel leans, as those of two-wheelers do; a flat one, 0, stays on its middle.
    double crown = 0;
};

// Two wheels of an axle: presses in the one by stiffness times the difference of their travels.
struct AntiRollBar {
    std::uint32_t left = 0, right = 1;  // wheels
    double stiffness = 10'000;          // N/m, 0 to 1e7
};

// Where torque splits it does so by drive shares, whatever the speeds: an open differential. A
// coupling holds the mean speeds of two groups of wheels together: left and right of an axle, or
// front and rear.
enum class DifferentialLockKind : std::uint8_t {
    limited_slip,  // by at most preload + ratio * |torque of the gearbox|
    locked,        // at any torque
};
struct DifferentialLock {
    std::vector<std::uint32_t> first = {}, second = {};  // wheels, at least one each
    DifferentialLockKind kind = DifferentialLockKind::limited_slip;
    double preload = 50;  // N m, 0 to 1e7
    double ratio = 0.3;   // 0 to 10
};

// Of what steers by the speeds of its two sides: a shaft from the engine to their difference (the
// double differential of Merritt and Brown). Steered to the right, the left side turns faster than
// the right one by 2 * ratio * steering * speed of the engine, whatever the gear: in neutral the
// vehicle turns on the spot. Steered straight it holds the sides together.
struct SteeringDrive {
    std::vector<std::uint32_t> left = {}, right = {};  // wheels; both empty: there is none
    double ratio = 0.03;                               // 0 to 100
    double torque = 20'000;                            // N m that it bears at most, 0 to 1e8
};

struct TorquePoint {
    double speed = 0;   // rad/s, 0 to 1e4, rising
    double torque = 0;  // N m at full throttle, -1e6 to 1e6
};
struct Engine {
    std::vector<TorquePoint> curve = {{0, 120},   {100, 190}, {250, 240},
                                      {450, 250}, {600, 220}, {700, 160}};
    double inertia = 0.2;    // kg m^2, with flywheel, 0.001 to 1e5
    double idle_speed = 90;  // rad/s, 1 to 5000: held by the governor
    double max_speed = 680;  // rad/s, above idle, to 1e4: beyond it the fuel is cut
    double friction = 0.1;   // N m s/rad with the throttle closed, 0 to 1e4
};

struct Gearbox {
    bool automatic = true;
    std::vector<double> forward = {3.6, 2.1, 1.4, 1.0, 0.8};  // 0.01 to 1000 each
    double reverse = 3.3;                                     // 0.01 to 1000
    double final_ratio = 3.7;                                 // 0.01 to 1000
    double efficiency = 0.95;                                 // 0.1 to 1
    double shift_time = 0.25;                                 // s with the clutch open, 0 to 10
    double shift_pause = 0.6;  // s between two shifts of an automatic, 0 to 100
    // rad/s of the engine, 0 to 1e4, down < up; with little throttle it shifts up at half of
    // shift_up_speed, where the next gear would not shift down again.
    double shift_up_speed = 560, shift_down_speed = 230;
    double clutch_torque = 500;  // N m that it holds, 1 to 1e7
};

struct Aerodynamics {
    double drag_area = 0.7;     // m^2: coefficient times area, 0 to 1000
    double downforce_area = 0;  // m^2, 0 to 1000
    double density = 1.2;       // kg/m^3, 0 to 2000
};

// For two-wheelers: steering asks for a lean, and the front wheel is turned so that it comes: into
// a fall, and at first away from a bend. Below a speed feet on the ground help: a turn of the
// chassis that nothing bears.
struct Balance {
    bool enabled = false;
    double max_lean_angle = 0.7;  // rad at full lock, 0 to 1.2
    double frequency = 0.8;       // Hz with which the lean follows, 0.1 to 5
    double feet_speed_max = 3;    // m/s, 0 to 20; 0: never
};

struct VehicleDef {
    BodyId chassis = {};  // a dynamic body
    std::vector<Wheel> wheels = {};
    std::vector<AntiRollBar> anti_roll_bars = {};
    std::vector<DifferentialLock> differential_locks = {};
    SteeringDrive steering_drive = {};
    Engine engine = {};
    Gearbox gearbox = {};
    Aerodynamics aerodynamics = {};
    Balance balance = {};
    WheelCast cast = WheelCast::cylinder;
    std::uint32_t ground = 0xffffffff;  // categories of shapes that wheels stand on
    double steering_rate = 2.5;         // 1/s of full lock, 0.01 to 1000
    // 1/s, 10 to 1e5: how often the car is solved, at most in every sub-step of the world. What it
    // pushes holds for several sub-steps where they are shorter.
    double rate = 120;
};

// Four wheels for a chassis: front left, front right, rear left, rear right.
struct SaloonDef {
    BodyId chassis = {};
    double track = 1.6, wheel_base = 2.7;  // m
    double height = 0;                     // m of the attachments in the chassis
    double middle = 0;                     // m along z of the middle between the axles
    double front_drive = 0;                // share of the front axle, 0 to 1
    Wheel wheel = {};                      // for all four
    double steering_most = 0.6;
    double hand_brake_torque = 3000;  // of each rear wheel
    double anti_roll = 8'000;         // N/m, of both axles
};
VehicleDef saloon(const SaloonDef& def);

// Two tracks: along each the wheels turn as one. The engine drives them against each other to
// steer, also where it stands; with a ratio of 0 only brakes steer.
struct TrackedDef {
    BodyId chassis = {};
    double gauge = 2, length = 3;     // m between the tracks, and between their outermost wheels
    std::uint32_t wheels = 5;         // of each side, 2 to 8
    double height = 0, middle = 0;    // m, as of a saloon
    Wheel wheel = {};                 // for all
    double steering_ratio = 0.03;     // of the steering drive
    double steering_torque = 20'000;  // N m
    double steering_brake = 0;        // N m of each wheel
};
VehicleDef tracked(const TrackedDef& def);

// Front and rear, the rear one driven.
struct MotorcycleDef {
    BodyId chassis = {};
    double wheel_base = 1.5, height = 0, middle = 0;  // m
    Wheel wheel = {};                                 // for both; its tread is made round
    double steering_most = 0.6;
};
VehicleDef motorcycle(const MotorcycleDef& def);

}  // namespace jostle::modules
