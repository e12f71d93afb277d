// SPDX-License-Identifier: MIT
//
// With angular frequency w, damping ratio 1, and the body's mass m: stiffness k = m w^2, damping c
// = 2 m w. Implicit Euler over dt turns the spring into a velocity constraint with softness g = 1 /
// (dt (c + dt k)) and bias b = dt k / (c + dt k) x / dt (Catto, "Soft Constraints", GDC 2011):
// impulse = -(K + g)^-1 (v + b), K the inverse mass at the point.
#include "host/drag_spring.h"

namespace jostle::server {

using namespace physics;

namespace {

constexpr double frequency = 5;           // Hz: follows a hand, does not shake
constexpr double acceleration_max = 200;  // m/s^2: a hand may be strong, not endless
constexpr double turn_damping = 4;        // 1/s: a held body stops spinning about the hand

}  // namespace

Status pull(World& world, const DragSpring& spring, double dt) {
    const Result<BodyState> found = world.body(spring.body);
    if (!found.ok()) return found.error();
    const BodyState& body = *found;
    if (body.mass <= 0) return {};
    const Vec3 point = apply(body.pose, spring.anchor), arm = point - body.center;
    const double omega = 2 * pi * frequency;
    const double k = body.mass * omega * omega, c = 2 * body.mass * omega;
    const double softness = 1 / (dt * (c + dt * k)), bias = k / (c + dt * k);
    const Mat3 r = skew(arm);
    const Mat3 inverse_mass =
        diagonal(Vec3{1, 1, 1} * (1 / body.mass + softness)) - r * inverse(body.inertia) * r;
    const Vec3 velocity = body.linear_velocity + cross(body.angular_velocity, arm);
    Vec3 impulse = inverse(inverse_mass) * -(velocity + (point - spring.target) * bias);
    const double most = body.mass * acceleration_max * dt, size = length(impulse);
    if (size > most) impulse = impulse * (most / size);
    if (Status s = world.apply_impulse(spring.body, impulse, point); !s.ok()) return s;
    const double lost = turn_damping * dt / (1 + turn_damping * dt);
    return world.apply_angular_impulse(spring.body, body.inertia * body.angular_velocity * -lost);
}

}  // namespace jostle::server
