// SPDX-License-Identifier: MIT
//
// Lengths and speeds of tuning.h for bodies of any size. A scene that is scaled in all its lengths
// is to do the same as before (Froude): lengths in proportion to size, speeds to the square root of
// size and gravity. Bodies of usual size, at the usual gravity, take the constants as they are.
// Sizes are the radius of the ball around the body, m; of a pair that of the smaller body.
#pragma once

#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// 1 of what is usual, else how many times it is as large. What has no size counts as usual.
inline double size_scale(double size) {
    if (size >= tuning::min_usual_size)
        return size <= tuning::max_usual_size ? 1 : size / tuning::max_usual_size;
    return size > 0 ? size / tuning::min_usual_size : 1;
}

// Gravity over the usual one, squared; 1 where there is none.
inline double gravity_ratio_squared(Vec3 gravity) {
    const double g2 = length_squared(gravity);
    return g2 > 0 ? g2 / (tuning::usual_gravity * tuning::usual_gravity) : 1;
}

// By what a usual speed is multiplied.
inline double speed_scale(double size, double gravity_ratio_squared) {
    if (size <= 0) return 1;
    constexpr double low_rate = 1 / tuning::min_usual_size, high_rate = 1 / tuning::max_usual_size;
    const double low = size * low_rate, high = size * high_rate;
    const double fourth =
        minimum(low * low * gravity_ratio_squared, maximum(1, high * high * gravity_ratio_squared));
    return fourth == 1 ? 1 : square_root(square_root(fourth));
}

// Whether the contact solver takes lengths and speeds of a pair's own.
inline bool is_unusual(double size, double gravity_ratio_squared) {
    return size_scale(size) != 1 || speed_scale(size, gravity_ratio_squared) != 1;
}

}  // namespace jostle::physics
