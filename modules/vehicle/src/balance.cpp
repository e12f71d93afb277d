// SPDX-License-Identifier: MIT
//
// Seen along its way a two-wheeler is a pendulum upside down whose foot the steering moves (Getz,
// Marsden, "Control for an autonomous bicycle", 1995, without the trail): with the lean phi, the
// speed v, the wheel base L, the front wheel's angle delta, all to the right, and the height l of a
// pendulum of the same fall,
//
//     l phi'' = g sin phi - a cos phi,   a = v^2 tan(delta) / L
//
// The lean shall follow as phi'' = w^2 (wanted - phi) - 2 w phi'. That gives a, and so delta: to
// lean to the right it is first turned to the left.
#include "balance.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

double axle_distance(const VehicleDef& def) {
    return maximum(absolute(def.wheels.back().attachment.z - def.wheels.front().attachment.z), 0.1);
}

// rad/s^2
double wanted_turn(const Car& car) {
    const double w = 2 * pi * car.def.balance.frequency;
    const double wanted = car.controls.steering * car.def.balance.lean_most;
    return w * w * (wanted - car.lean.angle) - 2 * w * car.lean.rate;
}

}  // namespace

void measure_lean(const BodyState& chassis, Car& car) {
    Vec3 normal{}, point{};
    double touching = 0;
    for (const WheelRun& run : car.wheels) {
        if (!run.touches) continue;
        normal += run.normal;
        point += run.point;
        touching += 1;
    }
    if (touching == 0) return;
    normal = normalized(normal);
    const Vec3 right = rotate(chassis.pose.rotation, {1, 0, 0});
    const Vec3 up = rotate(chassis.pose.rotation, {0, 1, 0});
    const Vec3 ahead = rotate(chassis.pose.rotation, {0, 0, -1});
    const double height = maximum(dot(chassis.center - point / touching, up), 0.05);
    const double inertia = dot(ahead, chassis.inertia * ahead);
    car.lean.angle = arc_tangent(-dot(right, normal), dot(up, normal));
    car.lean.rate = dot(chassis.angular_velocity, ahead);
    car.lean.height = height + inertia / (chassis.mass * height);
    car.lean.weight = maximum(-dot(car.other_a, normal), 0.1);
    car.lean.inertia = inertia + chassis.mass * height * height;
}

double balance_steering(const Car& car) {
    const SinCos lean = sin_cos(car.lean.angle);
    const double aside =
        (car.lean.weight * lean.sin - car.lean.height * wanted_turn(car)) / maximum(lean.cos, 0.2);
    const double v2 = maximum(car.speed * car.speed, 1);
    const double angle = arc_tangent(aside * axle_distance(car.def), v2);
    return clamp(angle / full_lock(car.def), -1, 1);
}

// As a pendulum without a foot that moves; fades to nothing with the speed.
Vec3 balance_by_feet(const Frame& frame, const Car& car) {
    const Balance& balance = car.def.balance;
    const double share = 1 - absolute(car.speed) / maximum(balance.feet_below, 1e-9);
    if (!balance.on || share <= 0) return {};
    const double w = 2 * pi * balance.frequency;
    const double upright = -w * w * car.lean.angle - 2 * w * car.lean.rate -
                           car.lean.weight / car.lean.height * car.lean.angle;
    return frame.axes.z * (-upright * share * car.lean.inertia * frame.h);
}

}  // namespace jostle::modules::vehicle_detail
