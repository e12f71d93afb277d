// SPDX-License-Identifier: MIT
//
// Seen along its direction of travel, a two-wheeler is an inverted pendulum whose foot is moved by
// steering (N. H. Getz, J. E. Marsden, "Control for an autonomous bicycle", 1995, without trail).
// Let phi be the lean angle of the line from the contact to the centre of mass, v the speed, L the
// wheel base, delta the angle of the front wheel (angles positive to the right), and l the length
// of the equivalent pendulum:
//
//     l phi'' = g sin phi - a cos phi
//
// The lean shall follow phi'' = w^2 (target - phi) - 2 w phi', which determines the lateral
// acceleration a. With the centre of mass at the distance b in front of the rear wheel, and tyres
// with a cornering stiffness of c m g per rad of slip, a depends on the steering as (Pacejka, "Tire
// and Vehicle Dynamics", 3rd edition, 1.3.2)
//
//     a + t a' = v^2 / L tan(delta) + b v / L delta',   t = v / (c g) + relaxation length / v
//
// This is solved for delta, with a' from the change of the desired a in the current fall. At low
// speed, the term b v delta' / L moves the foot. At high speed, t is longer than a fall; then the
// front wheel is steered to the slip angle at which its tyre provides its share of a immediately,
// and the rear wheel follows. To lean to the right, it first steers to the left.
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

constexpr double speed_min = 0.5;  // m/s, minimum speed in the steering law
// m/s, range in which the two steering laws are blended
constexpr double blend_speed_low = 15, blend_speed_high = 30;
constexpr double swing_damping_seconds = 0.025;  // s
constexpr double rider_friction_share = 0.85;    // fraction of the friction that a rider uses

double axle_distance(const VehicleDef& def) {
    return maximum(absolute(def.wheels.back().attachment.z - def.wheels.front().attachment.z), 0.1);
}

// Fraction of the support by the feet: 1 at standstill or when rolling backward.
double feet_support_share(const Car& car) {
    const double below = car.def.balance.feet_speed_max;
    return below > 0 ? clamp(2 - 2 * car.speed / below, 0, 1) : 0;
}

double least_friction(const Car& car) {
    double least = 10;
    for (const WheelRuntime& run : car.wheels)
        if (run.touches) least = minimum(least, run.friction);
    return least;
}

// rad, limited by friction and full lock at this speed.
double target_lean_angle(const Car& car) {
    const double v = maximum(car.speed, speed_min);
    const double locked = v * v * full_lock(car.def) / axle_distance(car.def) / car.lean.weight;
    const double most = arc_tangent(rider_friction_share * minimum(least_friction(car), locked), 1);
    return clamp(car.controls.steering * car.def.balance.max_lean_angle, -most, most);
}

// Desired lateral acceleration a and its derivative.
struct LateralAcceleration {
    double desired, change;  // m/s^2, m/s^3
};
LateralAcceleration target_lateral_acceleration(const Car& car) {
    const Lean& lean = car.lean;
    const double w = 2 * pi * car.def.balance.frequency, g = lean.weight, l = lean.height;
    const SinCos angle = sin_cos(lean.angle);
    const double cos = maximum(angle.cos, 0.2);
    // Limits the angular acceleration to a fraction of that of gravity.
    const double most = 0.3 * g / l;
    const double turn =
        clamp(w * w * (target_lean_angle(car) - lean.angle), -most, most) - 2 * w * lean.rate;
    double pushed = 0;
    for (const WheelRuntime& run : car.wheels) pushed += run.lateral;
    const double falls = (g * angle.sin - pushed / car.mass * cos) / l;
    return {(g * angle.sin - l * turn) / cos, (g + l * w * w) * lean.rate + 2 * l * w * falls};
}

// Slip angle, rad, at which the tyre, modelled as a brush (tyre.h), uses a fraction of the
// friction: share = 1 - (1 - c / (3 mu) slip)^3.
double slip_for(double share, double friction, double stiffness) {
    const double left = 1 - minimum(absolute(share), rider_friction_share);
    double root = 1 - (1 - left) / 3;
    for (int round = 0; round < 4; round++) root -= (root * root * root - left) / (3 * root * root);
    const double slip = 3 * friction / stiffness * (1 - root);
    return share < 0 ? -slip : slip;
}

// Steering angle, rad, determined by the path of the rolling wheel.
double steering_from_path(const Car& car, const LateralAcceleration& lateral, double dt) {
    const double v = maximum(car.speed, speed_min), base = axle_distance(car.def);
    const Tyre& tyre = car.def.wheels.front().tyre;
    const double lags =
        v / (tyre.cornering_stiffness * car.lean.weight) + tyre.relaxation_length / maximum(v, 2);
    const double target = (lateral.desired + lags * lateral.change) * base / (v * v);
    const double foot = 0.5 * base / (v * dt);
    return (target + foot * car.steering * full_lock(car.def)) / (1 + foot);
}

// Steering angle, rad, determined by the tyre force: the direction of motion of the wheel plus the
// slip angle for its share.
double steering_from_slip(const Car& car, const LateralAcceleration& lateral) {
    const double friction = maximum(least_friction(car), 0.01);
    const double share = lateral.desired / (friction * car.lean.weight);
    // Damps rotation about the vertical axis, except for the yaw rate of the bend.
    const double swings = car.lean.yaw_rate - lateral.desired / maximum(car.speed, blend_speed_low);
    return car.lean.front_heading - swing_damping_seconds * swings +
           slip_for(share, friction, car.def.wheels.front().tyre.cornering_stiffness);
}

}  // namespace

void measure_lean(const BodyState& chassis, Car& car) {
    Vec3 normal{}, point{};
    double touching = 0;
    for (const WheelRuntime& run : car.wheels) {
        if (!run.touches) continue;
        normal += run.normal;
        point += run.point;
        touching += 1;
    }
    car.lean.touching = touching > 0;
    if (touching == 0) return;
    normal = normalized(normal, {0, 1, 0});
    const Vec3 forward = rotate(chassis.pose.rotation, {0, 0, -1});
    const Vec3 right = normalized(cross(forward, normal), {1, 0, 0});
    // Perpendicular to the direction of travel, because the contact points are from the previous
    // step.
    const Vec3 v = chassis.linear_velocity, along = v - normal * dot(v, normal);
    const Vec3 course = length_squared(along) > 9 ? normalized(along) : forward;
    const Vec3 across = normalized(cross(course, normal), {1, 0, 0});
    const Vec3 up = cross(across, course), arm = chassis.center - point / touching;
    const double lateral = dot(arm, across), above = dot(arm, up);
    const double height = maximum(square_root(lateral * lateral + above * above), 0.05);
    const double inertia = dot(forward, chassis.inertia * forward);
    car.lean.angle = arc_tangent(lateral, above);
    car.lean.rate = dot(chassis.angular_velocity, forward);
    car.lean.height = height + inertia / (chassis.mass * height);
    car.lean.weight = maximum(-dot(car.external_acceleration, normal), 0.1);
    car.lean.own_inertia = inertia;
    car.lean.yaw_rate = -dot(chassis.angular_velocity, normal);
    car.lean.inertia = inertia + chassis.mass * height * height;
    const Vec3 hub = apply(chassis.pose, car.def.wheels.front().attachment);
    const Vec3 front = v + cross(chassis.angular_velocity, hub - chassis.center);
    car.lean.front_heading =
        arc_tangent(dot(front, right), maximum(dot(front, forward), speed_min));
}

double balance_steering(const Car& car, double dt) {
    if (!car.lean.touching) return car.steering;
    const double share = feet_support_share(car), lock = full_lock(car.def);
    const LateralAcceleration lateral = target_lateral_acceleration(car);
    const double by_slip =
        clamp((car.speed - blend_speed_low) / (blend_speed_high - blend_speed_low), 0, 1);
    double angle = 0;
    if (by_slip < 1) angle += (1 - by_slip) * steering_from_path(car, lateral, dt);
    if (by_slip > 0) angle += by_slip * steering_from_slip(car, lateral);
    return clamp((1 - share) * angle / lock + share * car.controls.steering, -1, 1);
}

// Controls a pendulum with a fixed foot; fades to zero with speed. The force of the feet is limited
// to the weight at a lever of 0.5 m. They do not lift a vehicle that lies on its side.
Vec3 feet_angular_impulse(const ChassisFrame& frame, const Car& car) {
    const Balance& balance = car.def.balance;
    const Lean& lean = car.lean;
    const double share = feet_support_share(car);
    if (!balance.enabled || share <= 0 || !lean.touching) return {};
    const double upright_share = clamp((1.1 - absolute(lean.angle)) / 0.4, 0, 1);
    const double w = 2 * pi * balance.frequency;
    const double rate = -dot(frame.w, frame.axes.z), damps = 2 * w * lean.inertia;
    const double stands = (w * w + lean.weight / lean.height) * lean.inertia;
    // Implicit for the chassis alone, because its tyres yield sideways.
    const double upright =
        -stands * lean.angle - damps * rate / (1 + frame.h * damps / lean.own_inertia);
    const double most = 0.5 * car.mass * lean.weight;
    return frame.axes.z * (-clamp(upright, -most, most) * share * upright_share * frame.h);
}

// Brake torque that a rider applies, N m: limited to the friction left by the lateral force, and
// reduced when the rear wheel is about to lift.
double rider_brake(const Car& car, std::size_t wheel, double requested) {
    if (!car.def.balance.enabled || absolute(car.speed) < speed_min) return requested;
    const WheelRuntime& run = car.wheels[wheel];
    const double grip = rider_friction_share * run.friction * run.load;
    const double forward = square_root(maximum(grip * grip - run.lateral * run.lateral, 0));
    const double weight = car.mass * car.lean.weight;
    const double stays = clamp(car.wheels.back().load / weight / 0.15, 0, 1);
    return minimum(requested, forward * stays * car.def.wheels[wheel].radius);
}

// Fraction of the throttle: reduced when the front wheel is about to lift or the rear wheel to
// spin.
double rider_throttle(const Car& car) {
    if (!car.def.balance.enabled) return 1;
    const double weight = car.mass * car.lean.weight;
    const double stays = clamp(car.wheels.front().load / weight / 0.15, 0, 1);
    const WheelRuntime& rear = car.wheels.back();
    const double slip = car.def.wheels.back().radius * rear.spin - car.speed;
    const double grips = clamp(2 - slip / maximum(0.05 * absolute(car.speed), 0.3), 0, 1);
    return minimum(stays, grips);
}

}  // namespace jostle::modules::vehicle_detail
