// SPDX-License-Identifier: MIT
//
// The relative motion of the two bodies of a pair.
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

struct BodyMotion {
    Vec3 center, v, w;  // m, m/s, rad/s
};
inline BodyMotion motion_of(const BodySets& sets, std::uint32_t body) {
    const BodyWarm& warm = warm_of(sets, body);
    return {warm.center, warm.v, warm.w};
}

// Upper bound of the relative displacement of any two points of the bodies in a step, m.
inline double max_closing_distance(const BodySets& sets, const Contact& c, double dt) {
    const BodyCold &a = sets.bodies.cold[c.body_a], &b = sets.bodies.cold[c.body_b];
    const BodyMotion ma = motion_of(sets, c.body_a), mb = motion_of(sets, c.body_b);
    const double turning_b = b.type == BodyType::static_body ? 0 : length(mb.w) * b.radius;
    return (length(ma.v - mb.v) + length(ma.w) * a.radius + turning_b) * dt;
}

}  // namespace jostle::physics
