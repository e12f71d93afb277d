// SPDX-License-Identifier: MIT
//
// The box by which the pairs of a moving shape are found: larger than the shape, so that small
// motion needs no new one, and stretched ahead.
#pragma once

#include "jostle/physics/aabb.h"
#include "jostle/physics/scalar.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// Of a body with this radius, m.
inline double fat_margin_of(double radius) {
    return tuning::fat_margin * size_scale(radius);
}

// `step`: m, what it moves in one step. `radius`: m, of the ball around its body.
inline Aabb fat_box(const Aabb& shape, Vec3 step, double radius) {
    const Aabb wide = grow(shape, fat_margin_of(radius));
    const double displacement = length(step), most = tuning::fat_lookahead_radii * radius;
    const bool far = displacement * tuning::fat_lookahead_steps > most;
    const Vec3 lookahead =
        step * (far ? maximum(1, most / displacement) : tuning::fat_lookahead_steps);
    return {wide.low + min(lookahead, Vec3{}), wide.high + max(lookahead, Vec3{})};
}

}  // namespace jostle::physics
