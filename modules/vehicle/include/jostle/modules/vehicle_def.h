// SPDX-License-Identifier: MIT
//
// Definition of a car. The defaults are those of a drivable saloon of 1,500 kg. Units are SI.
// Vehicles::add() rejects a value out of range with an Error that names it. In the frame of the
// chassis body, y points up, -z forward and x to the right.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

using physics::BodyId;
using physics::Vec3;

/// Maximum number of wheels of a car.
inline constexpr std::size_t wheels_max = 16;
/// Maximum number of limited-slip or locked differentials of a car.
inline constexpr std::size_t differential_locks_max = 16;
/// Maximum number of anti-roll bars of a car.
inline constexpr std::size_t anti_roll_bars_max = 6;
/// Maximum number of points of an engine's torque curve.
inline constexpr std::size_t curve_points_max = 16;
/// Maximum number of forward gears.
inline constexpr std::size_t gears_max = 12;

/// How a wheel finds the ground: by a query along its suspension once per step, whose contact plane
/// is valid for that step; or as a body with contacts of its own.
enum class WheelCast : std::uint8_t {
    ray,       ///< at the wheel's middle: the cheapest, but it falls into every gap
    sphere,    ///< a sphere of the wheel's radius
    cylinder,  ///< the exact wheel: climbs kerbs
    /// Each wheel is a cylinder body of `mass` on a wheel joint of the solver, which provides
    /// suspension, steering and brakes. It has Coulomb friction, the inertia of a solid cylinder,
    /// and hard stops at both ends of its suspension. Not available with `balance`. A wheel may
    /// rotate at most 0.3 rad per sub-step (45 m/s for a radius of 0.33 m at 480 sub-steps per
    /// second); above that, the solver does not keep it straight.
    body,
};

/// A brush tyre with relaxation (H. B. Pacejka, "Tire and Vehicle Dynamics", 3rd edition, chapters
/// 3.2 and 7). The slip between the contact patch and the ground deflects the tread, limited by
/// friction in the combined longitudinal and lateral direction.
struct Tyre {
    /// Coulomb coefficient, 0 to 10. Combined with the friction of the ground according to
    /// friction_rule (Combine).
    double friction = 1;
    physics::Combine friction_rule = physics::Combine::geometric_mean;
    double longitudinal_stiffness = 20;  ///< force per load and slip, 1 to 100
    double cornering_stiffness = 15;     ///< force per load and rad of slip angle, 1 to 100
    /// m, rolling distance over which the force builds up, 0.02 to 3
    double relaxation_length = 0.3;
    double damping = 0.5;               ///< damping ratio of the tread at standstill, 0 to 2
    double rolling_resistance = 0.012;  ///< force per load, 0 to 0.5
};

/// Suspension of a wheel.
struct Suspension {
    /// Distance from the attachment to the wheel's centre, m: fully compressed and fully extended.
    /// -10 to 10; max_length at least 1 mm more than min_length.
    double min_length = 0.1, max_length = 0.45;
    /// Natural frequency of the mass that rests on this wheel: stiffness = mass (2 pi frequency)^2.
    double frequency = 1.5;  ///< Hz, 0.1 to 100
    double damping = 0.3;    ///< damping ratio, 0 to 10
    /// Spring force at full extension, N, 0 to 1e7.
    double preload = 0;
};

/// Definition of a wheel.
struct Wheel {
    Vec3 attachment = {};    ///< m, in the chassis frame; each component within 100
    Vec3 down = {0, -1, 0};  ///< direction of suspension travel; not zero, normalized by add()
    Vec3 axle = {1, 0, 0};   ///< to the right without steering; perpendicular to `down`
    double radius = 0.33;    ///< m, 0.02 to 10
    double width = 0.22;     ///< m, 0.01 to 10
    double inertia = 1.2;    ///< kg m^2 about the axle, 0.001 to 1e5
    /// kg, for WheelCast::body only, 0.01 to 1e6; otherwise the chassis includes it
    double mass = 20;
    Suspension suspension = {};
    Tyre tyre = {};
    double max_steering_angle =
        0;  ///< rad at full lock, -1.4 to 1.4; negative steers the opposite way
    /// Fraction of the gearbox torque, 0 to 1; all wheels must sum to 0 or 1.
    double drive_share = 0;
    double brake_torque = 1500;    ///< N m at full brake, 0 to 1e7
    double hand_brake_torque = 0;  ///< N m, 0 to 1e7
    /// Brake torque for steering of tracked vehicles, N m at full lock, -1e7 to 1e7. Positive
    /// brakes when steering to the right, negative when steering to the left.
    double steering_brake = 0;
    /// Radius of the tread's cross-section, m, 0 to the radius. With a round tread, as on
    /// two-wheelers, the contact point moves to the side of a leaning wheel. With 0, a flat tread,
    /// it stays in the middle.
    double crown = 0;
};

/// Connects two wheels of an axle with a spring that acts on the difference of their travels.
/// Fields are indices of wheels.
struct AntiRollBar {
    std::uint32_t left = 0, right = 1;
    double stiffness = 10'000;  ///< N/m, 0 to 1e7
};

/// A differential that limits the speed difference of two groups of wheels: left and right of an
/// axle, or front and rear. It couples their mean speeds. Without one, torque is split by drive
/// shares regardless of speeds, as in an open differential.
enum class DifferentialLockKind : std::uint8_t {
    limited_slip,  ///< coupling torque up to preload + ratio * |gearbox torque|
    locked,        ///< unlimited coupling torque
};
/// A limited-slip or locked differential.
struct DifferentialLock {
    /// Indices of wheels, at least one each, all different.
    std::vector<std::uint32_t> first = {}, second = {};
    DifferentialLockKind kind = DifferentialLockKind::limited_slip;
    double preload = 50;  ///< N m, 0 to 1e7
    double ratio = 0.3;   ///< 0 to 10
};

/// Steering drive of tracked vehicles: a shaft that drives the speed difference of the two sides
/// from the engine (double differential of Merritt and Brown). Steering to the right makes the left
/// side faster than the right side by 2 * ratio * steering * engine speed, in any gear. In neutral,
/// the vehicle turns on the spot. Without steering, it couples the sides.
struct SteeringDrive {
    /// Indices of wheels; both empty disables it.
    std::vector<std::uint32_t> left = {}, right = {};
    double ratio = 0.03;     ///< 0 to 100
    double torque = 20'000;  ///< N m, maximum torque, 0 to 1e8
};

/// A point of a torque curve.
struct TorquePoint {
    double speed = 0;   ///< rad/s, 0 to 1e4, strictly increasing
    double torque = 0;  ///< N m at full throttle, -1e6 to 1e6
};
/// Engine of a car.
struct Engine {
    /// 1 to curve_points_max points; linear in between, constant beyond the ends.
    std::vector<TorquePoint> curve = {{0, 120},   {100, 190}, {250, 240},
                                      {450, 250}, {600, 220}, {700, 160}};
    double inertia = 0.2;    ///< kg m^2, including the flywheel, 0.001 to 1e5
    double idle_speed = 90;  ///< rad/s, 1 to 5000; the governor maintains it
    double max_speed = 680;  ///< rad/s, above idle_speed, at most 1e4; the fuel is cut beyond it
    double friction = 0.1;   ///< N m s/rad with closed throttle, 0 to 1e4
};

/// Gearbox and clutch of a car.
struct Gearbox {
    bool automatic = true;
    /// Ratios of the forward gears, 0.01 to 1000 each; 1 to gears_max gears.
    std::vector<double> forward = {3.6, 2.1, 1.4, 1.0, 0.8};
    double reverse = 3.3;      ///< 0.01 to 1000
    double final_ratio = 3.7;  ///< 0.01 to 1000
    double efficiency = 0.95;  ///< 0.1 to 1
    double shift_time = 0.25;  ///< s with open clutch, 0 to 10
    double shift_pause = 0.6;  ///< s, minimum time between two shifts of an automatic, 0 to 100
    /// Engine speeds at which an automatic shifts, rad/s, 0 to 1e4, shift_down_speed <
    /// shift_up_speed. With little throttle it shifts up from half of shift_up_speed, unless the
    /// next gear would shift down again.
    double shift_up_speed = 560, shift_down_speed = 230;
    double clutch_torque = 500;  ///< N m, maximum torque, 1 to 1e7
};

/// Aerodynamics of a car.
struct Aerodynamics {
    double drag_area = 0.7;     ///< m^2, drag coefficient times area, 0 to 1000
    double downforce_area = 0;  ///< m^2, downforce coefficient times area, 0 to 1000
    double density = 1.2;       ///< kg/m^3, of the air, 0 to 2000
};

/// Balance control of two-wheelers. Steering input requests a lean angle, and the front wheel is
/// steered to reach it: into a fall, and initially away from the bend. At low speed, the rider's
/// feet help with a torque on the chassis that has no reaction.
struct Balance {
    bool enabled = false;
    double max_lean_angle = 0.7;  ///< rad, at full steering input, 0 to 1.2
    double frequency = 0.8;       ///< Hz, of the lean controller, 0.1 to 5
    double feet_speed_max = 3;    ///< m/s, speed up to which feet help, 0 to 20; 0 disables them
};

/// Definition of a car.
struct VehicleDef {
    BodyId chassis = {};  ///< a dynamic body that is not part of another car
    /// 1 to wheels_max wheels.
    std::vector<Wheel> wheels = {};
    /// At most anti_roll_bars_max.
    std::vector<AntiRollBar> anti_roll_bars = {};
    /// At most differential_locks_max.
    std::vector<DifferentialLock> differential_locks = {};
    SteeringDrive steering_drive = {};
    Engine engine = {};
    Gearbox gearbox = {};
    Aerodynamics aerodynamics = {};
    Balance balance = {};
    WheelCast cast = WheelCast::cylinder;
    std::uint32_t ground = 0xffffffff;  ///< category bits of shapes that wheels can stand on
    double steering_rate = 2.5;  ///< 1/s, speed of steering in units of full lock, 0.01 to 1000
    /// Solves per second, 10 to 1e5, limited to one per sub-step of the world. If sub-steps are
    /// shorter, one solve covers several of them.
    double rate = 120;
};

/// Parameters of a four-wheeled car: front left, front right, rear left, rear right.
struct SaloonDef {
    BodyId chassis = {};
    double track = 1.6, wheel_base = 2.7;  ///< m
    double height = 0;                     ///< m, height of the attachments in the chassis frame
    double center_z = 0;              ///< m, z of the middle between the axles in the chassis frame
    double front_drive = 0;           ///< drive share of the front axle, 0 to 1
    Wheel wheel = {};                 ///< template of all four wheels
    double max_steering_angle = 0.6;  ///< rad, of the front wheels
    double hand_brake_torque = 3000;  ///< N m, per rear wheel
    double anti_roll = 8'000;         ///< N/m, per axle
};
/// Returns the definition of a four-wheeled car.
VehicleDef saloon(const SaloonDef& def);

/// Parameters of a tracked vehicle. The wheels of each track turn together. The engine steers by
/// driving the tracks against each other, also at standstill. With a steering ratio of 0, only the
/// brakes steer.
struct TrackedDef {
    BodyId chassis = {};
    double gauge = 2, length = 3;     ///< m, between the tracks, and between the outermost wheels
    std::uint32_t wheels = 5;         ///< per side, 2 to 8
    double height = 0, center_z = 0;  ///< m, as in SaloonDef
    Wheel wheel = {};                 ///< template of all wheels
    double steering_ratio = 0.03;     ///< SteeringDrive::ratio
    double steering_torque = 20'000;  ///< N m, SteeringDrive::torque
    double steering_brake = 0;        ///< N m per wheel
};
/// Returns the definition of a tracked vehicle.
VehicleDef tracked(const TrackedDef& def);

/// Parameters of a motorcycle: a front wheel and a driven rear wheel.
struct MotorcycleDef {
    BodyId chassis = {};
    double wheel_base = 1.5, height = 0, center_z = 0;  ///< m
    Wheel wheel = {};                 ///< template of both wheels; its tread becomes round
    double max_steering_angle = 0.6;  ///< rad, of the front wheel
};
/// Returns the definition of a motorcycle.
VehicleDef motorcycle(const MotorcycleDef& def);

}  // namespace jostle::modules
