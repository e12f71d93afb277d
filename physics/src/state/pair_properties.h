// SPDX-License-Identifier: MIT
//
// Properties of a pair of bodies: the combined coefficients of their materials, and the size for
// the lengths of tuning.h, which is that of its smaller dynamic body.
#pragma once

#include "jostle/physics/defs.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"

namespace jostle::physics {

inline double pair_friction(const Material& a, const Material& b) {
    return combine(a.friction, a.friction_rule, b.friction, b.friction_rule);
}
inline double pair_restitution(const Material& a, const Material& b) {
    return combine(a.restitution, a.restitution_rule, b.restitution, b.restitution_rule);
}

// Returns the size in m. The first body is dynamic.
inline double size_of_pair(const BodyCold& a, const BodyCold& b) {
    return b.type == BodyType::dynamic ? minimum(a.radius, b.radius) : a.radius;
}
inline double size_of_pair(const BodyStore& bodies, const Contact& c) {
    return size_of_pair(bodies.cold[c.body_a], bodies.cold[c.body_b]);
}
inline double scale_of_pair(const BodyStore& bodies, const Contact& c) {
    return size_scale(size_of_pair(bodies, c));
}

}  // namespace jostle::physics
