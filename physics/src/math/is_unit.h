// SPDX-License-Identifier: MIT
//
// Length of a direction, for assertions.
#pragma once

#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Returns whether the squared length of a vector is 1, up to the tolerance. True for NaN: bodies
// that are not finite pass through the collision code until the end of the step quarantines them.
// Other assertions on such numbers are written so that NaN passes, too: !(x < 0).
inline bool is_unit(Vec3 v, double tolerance = 1e-6) {
    return !(absolute(length_squared(v) - 1) > tolerance);
}

}  // namespace jostle::physics
