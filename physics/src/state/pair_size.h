// SPDX-License-Identifier: MIT
//
// Size of a pair of bodies for the lengths of tuning.h: that of its smaller dynamic body.
#pragma once

#include "physics/src/foundation/size_scale.h"
#include "physics/src/state/body_store.h"
#include "physics/src/state/contact_store.h"

namespace jostle::physics {

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
