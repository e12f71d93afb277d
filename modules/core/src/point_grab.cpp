// SPDX-License-Identifier: MIT
#include "jostle/modules/point_grab.h"

#include <algorithm>

#include "jostle/modules/settings.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules {

using namespace physics;

namespace {

constexpr double frequency = 2 * pi * 5;                // rad/s
constexpr double acceleration_max = 200;                // m/s^2
constexpr double target_max = 1e6, position_max = 1e9;  // m
constexpr double speed_max = 1e9;                       // m/s, of loaded grabs

}  // namespace

// Implicit Euler: v' = v + h (w^2 (target - x - h v') - 2 w v').
Vec3 PointGrab::pull(double h) const {
    const double w = frequency;
    const Vec3 force = (target - position - velocity * h) * (w * w) - velocity * (2 * w);
    const Vec3 acceleration = force * (1 / (1 + 2 * w * h + w * w * h * h));
    const double size = length(acceleration);
    return size > acceleration_max ? acceleration * (acceleration_max / size) : acceleration;
}

bool PointGrab::aim_at(Vec3 point) {
    const Vec3 size = abs(point);
    if (!(size.x <= target_max && size.y <= target_max && size.z <= target_max)) return false;
    target = point;
    return true;
}

void PointGrab::visit(StateVisitor& v) {
    v.field("holder", holder);
    bounded(v, "mass", mass, mass_min, mass_max);
    bounded(v, "target", target, position_max);
    bounded(v, "position", position, position_max);
    bounded(v, "velocity", velocity, speed_max);
    if (v.loading() && holder == 0) v.fail("holder", "is 0");
}

PointGrab make_point_grab(std::uint32_t holder, Vec3 point, double object_mass) {
    return {.holder = holder,
            .mass = std::clamp(object_mass, PointGrab::mass_min, PointGrab::mass_max),
            .target = point,
            .position = point};
}

}  // namespace jostle::modules
