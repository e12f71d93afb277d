// SPDX-License-Identifier: MIT
//
// The relative motion of the two bodies of a pair.
#pragma once

#include "physics/src/stages/relative_displacement.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

struct BodyMotion {
    Vec3 center, v, w;  // m, m/s, rad/s
};
inline BodyMotion motion_of(const BodySets& sets, std::uint32_t body) {
    const BodyWarm& warm = warm_of(sets, body);
    return {warm.center, warm.v, warm.w};
}

inline BodyDisplacement displacement_of(const BodySets& sets, std::uint32_t body, double dt) {
    const BodyMotion m = motion_of(sets, body);
    return {m.center, m.v * dt, m.w * dt, displaced_radius(sets.bodies.cold[body])};
}

// Upper bound of the relative displacement of two points of the bodies that may touch in a step, m.
// Forces may turn dynamic bodies within the step, so the bound does not rely on the rotation that
// they share.
inline double max_closing_distance(const BodySets& sets, const Contact& c, double dt) {
    const BodyDisplacement a = displacement_of(sets, c.body_a, dt),
                           b = displacement_of(sets, c.body_b, dt);
    return sets.bodies.cold[c.body_b].type == BodyType::dynamic ? displacement_anywhere(a, b)
                                                                : max_relative_displacement(a, b);
}

}  // namespace jostle::physics
