// SPDX-License-Identifier: MIT
//
// Where two shapes touch, or nearly do: up to four points that share one normal.
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

struct Manifold {
    int count = 0;  // 0..4 points
    // Unit, world, from a to b. When count is 0: the direction along which they are apart by
    // `distance`, or zero when that is not known.
    Vec3 normal;
    Vec3 point[4];       // m, world, half way between the surfaces
    double gap[4] = {};  // m, separation along the normal; negative: overlap
    double distance =
        0;  // m: when count is 0, a lower bound of the separation (more than the margin asked for)
};

// The same seen from the other shape.
inline Manifold flipped(Manifold m) {
    m.normal = -m.normal;
    return m;
}

}  // namespace jostle::physics
