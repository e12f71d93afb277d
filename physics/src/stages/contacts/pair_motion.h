// SPDX-License-Identifier: MIT
//
// The relative motion of the two bodies of a pair.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

struct BodyMotion {
    Vec3 center, v, w;  // m, m/s, rad/s
};
inline BodyMotion motion_of(const WorldState& world, std::uint32_t body) {
    const BodyWarm& warm = warm_of(world, body);
    return {warm.center, warm.v, warm.w};
}

// Upper bound of the relative displacement of any two points of the bodies in a step, m.
inline double max_closing_distance(const WorldState& world, const Contact& c, double dt) {
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const BodyMotion ma = motion_of(world, c.body_a), mb = motion_of(world, c.body_b);
    const double turning_b = b.type == BodyType::static_body ? 0 : length(mb.w) * b.radius;
    return (length(ma.v - mb.v) + length(ma.w) * a.radius + turning_b) * dt;
}

}  // namespace jostle::physics
