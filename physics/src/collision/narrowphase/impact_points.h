// SPDX-License-Identifier: MIT
//
// Where two shapes meet at the moment of an impact.
#pragma once

#include <vector>

#include "physics/src/collision/narrowphase/time_of_impact.h"

namespace jostle::physics {

struct ImpactPoint {
    Vec3 position, normal;  // m, world; unit, from a to b
};

// Where they touch at that fraction of the step, or are no further apart than `gap`, m; any kinds.
std::vector<ImpactPoint> points_touching(const SweptShape& a, const SweptShape& b, double fraction,
                                         double gap);

// Where the whole shapes meet along the normal at which a part of one met the other.
std::vector<ImpactPoint> points_along(const SweptShape& a, const SweptShape& b,
                                      const Impact& impact);

}  // namespace jostle::physics
