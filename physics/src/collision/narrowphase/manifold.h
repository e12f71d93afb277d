// SPDX-License-Identifier: MIT
//
// Contact points of two shapes that touch or nearly touch: up to four points with a common normal.
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

struct Manifold {
    int count = 0;  // 0..4 points
    // Unit, world, from a to b. If count is 0, the direction along which the shapes are `distance`
    // apart, or zero if it is unknown.
    Vec3 normal;
    Vec3 point[4];       // m, world, midway between the surfaces
    double gap[4] = {};  // m, separation along the normal; negative for overlap
    // m; if count is 0, a lower bound of the separation (greater than the requested margin).
    double distance = 0;
};

// The same manifold with the roles of the shapes swapped.
inline Manifold flipped(Manifold m) {
    m.normal = -m.normal;
    return m;
}

}  // namespace jostle::physics
