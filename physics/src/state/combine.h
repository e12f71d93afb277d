// SPDX-License-Identifier: MIT
//
// Combined coefficients of two materials.
#pragma once

#include "jostle/physics/defs.h"

namespace jostle::physics {

inline double pair_friction(const Material& a, const Material& b) {
    return combine(a.friction, a.friction_rule, b.friction, b.friction_rule);
}
inline double pair_restitution(const Material& a, const Material& b) {
    return combine(a.restitution, a.restitution_rule, b.restitution, b.restitution_rule);
}

}  // namespace jostle::physics
