// SPDX-License-Identifier: MIT
//
// Scaling of the lengths and speeds of tuning.h to bodies of any size. A uniformly scaled scene
// should behave the same (Froude scaling): lengths scale with the size, speeds with the square root
// of size times gravity. Bodies of usual size at standard gravity use the constants unscaled. The
// size of a body is the radius of its bounding sphere in m; the size of a pair is that of the
// smaller body.
#pragma once

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// Returns 1 in the usual range, otherwise the ratio to the nearest bound of the range. Size 0
// counts as usual.
inline double size_scale(double size) {
    if (size >= tuning::min_usual_size)
        return size <= tuning::max_usual_size ? 1 : size / tuning::max_usual_size;
    return size > 0 ? size / tuning::min_usual_size : 1;
}

// Returns the squared ratio of gravity to standard gravity; 1 without gravity.
inline double gravity_ratio_squared(Vec3 gravity) {
    const double g2 = length_squared(gravity);
    return g2 > 0 ? g2 / (tuning::usual_gravity * tuning::usual_gravity) : 1;
}

// Returns the factor for speeds.
inline double speed_scale(double size, double gravity_ratio_squared) {
    if (size <= 0) return 1;
    ASSERT(gravity_ratio_squared > 0);
    constexpr double low_rate = 1 / tuning::min_usual_size, high_rate = 1 / tuning::max_usual_size;
    const double low = size * low_rate, high = size * high_rate;
    const double fourth =
        minimum(low * low * gravity_ratio_squared, maximum(1, high * high * gravity_ratio_squared));
    return fourth == 1 ? 1 : square_root(square_root(fourth));
}

// Returns the ratio of the rate sqrt(gravity / size) of a body to that of the smallest body of
// usual size at standard gravity.
inline double time_scale_ratio(double size, double gravity_ratio_squared) {
    if (size <= 0) return 1;
    return square_root(square_root(gravity_ratio_squared) * (tuning::min_usual_size / size));
}

// Returns whether bodies of this size may need more sub-steps (choose_size_levels).
inline bool may_need_size_level(double size, Vec3 gravity) {
    return time_scale_ratio(size, gravity_ratio_squared(gravity)) > tuning::size_level_reserve;
}

// Returns the speed up to which impacts do not bounce, m/s. A bounce that is over within a step is
// noise: the speed rises with what gravity adds in a step of at most 1/60 s.
inline double bounce_speed(Vec3 gravity, double dt) {
    ASSERT(dt > 0);
    const double ratio = square_root(gravity_ratio_squared(gravity));
    return tuning::restitution_speed * maximum(1, ratio * minimum(1, dt * tuning::usual_rate));
}

// Returns whether a pair needs its own lengths and speeds in the contact solver.
inline bool is_unusual(double size, double gravity_ratio_squared) {
    return size_scale(size) != 1 || speed_scale(size, gravity_ratio_squared) != 1;
}

}  // namespace jostle::physics
