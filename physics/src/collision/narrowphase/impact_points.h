// SPDX-License-Identifier: MIT
//
// Contact points of two shapes at an impact.
#pragma once

#include <vector>

#include "physics/src/collision/narrowphase/time_of_impact.h"

namespace jostle::physics {

struct ImpactPoint {
    Vec3 position, normal;  // m, world; unit, from a to b
};

// Points where the shapes touch at that fraction of the step, or are at most `gap` metres apart.
// Supports all kinds.
std::vector<ImpactPoint> points_touching(const SweptShape& a, const SweptShape& b, double fraction,
                                         double gap);

// Points where the whole shapes touch along the normal of an impact between parts of them.
std::vector<ImpactPoint> points_along(const SweptShape& a, const SweptShape& b,
                                      const Impact& impact);

}  // namespace jostle::physics
