// SPDX-License-Identifier: MIT
//
// The enlarged box by which the broad phase finds the pairs of a moving shape. The margin avoids an
// update after small motion; the box also extends along the motion.
#pragma once

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"
#include "jostle/physics/scalar.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// Margin in metres of a body with this bounding radius in metres.
inline double fat_margin_of(double radius) {
    return tuning::fat_margin * size_scale(radius);
}

// `step`: displacement in one step, m. `radius`: bounding radius of the body, m.
inline Aabb fat_box(const Aabb& shape, Vec3 step, double radius) {
    const Aabb wide = grow(shape, fat_margin_of(radius));
    const double displacement = length(step), most = tuning::fat_lookahead_radii * radius;
    ASSERT(radius >= 0);
    const bool far = displacement * tuning::fat_lookahead_steps > most;
    const Vec3 lookahead =
        step * (far ? maximum(1, most / displacement) : tuning::fat_lookahead_steps);
    return {wide.low + min(lookahead, Vec3{}), wide.high + max(lookahead, Vec3{})};
}

}  // namespace jostle::physics
