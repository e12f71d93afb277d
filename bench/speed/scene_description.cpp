// SPDX-License-Identifier: MIT
#include "speed/scene_description.h"

namespace jostle::bench {
namespace {

using physics::pi;
using physics::Vec3;

SolidMass mass_of(const physics::Sphere& sphere) {
    const double r = sphere.radius, mass = density * 4 / 3 * pi * r * r * r,
                 turn = 0.4 * mass * r * r;
    return {mass, {turn, turn, turn}};
}

SolidMass mass_of(const physics::Box& box) {
    const Vec3 h = box.half_extents, s = scaled(h, h);
    const double mass = density * 8 * h.x * h.y * h.z;
    return {mass, Vec3{s.y + s.z, s.x + s.z, s.x + s.y} * (mass / 3)};
}

// A cylinder and two half balls, each of which has its own centre 3/8 r from its disc.
SolidMass mass_of(const physics::Capsule& capsule) {
    const double r = capsule.radius, length = 2 * capsule.half_length;
    const double tube = density * pi * r * r * length, ball = density * 4 / 3 * pi * r * r * r;
    const double along = tube * r * r / 2 + ball * 0.4 * r * r;
    const double across = tube * (length * length / 12 + r * r / 4) +
                          ball * (0.4 * r * r + length * length / 4 + 3.0 / 8 * length * r);
    return {tube + ball, {across, along, across}};
}

}  // namespace

SolidMass solid_mass(const Form& form) {
    return std::visit([](const auto& shape) { return mass_of(shape); }, form);
}

Vec3 player_velocity(int step) {
    const double time = step * step_seconds;
    const physics::SinCos turned = physics::sin_cos(time < 2.5 ? 0 : (time - 2.5) * 0.8);
    return Vec3{turned.cos, 0, turned.sin} * 6;
}

}  // namespace jostle::bench
