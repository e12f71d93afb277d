// SPDX-License-Identifier: MIT
//
// The angles between two world frames that joints limit.
#pragma once

#include "jostle/physics/joint_defs.h"
#include "jostle/physics/quat.h"

namespace jostle::physics {

double hinge_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double twist_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double swing_angle(Quat frame_a, Quat frame_b);  // rad, 0..pi

// Returns the same angle within half a turn of `near`, rad.
inline double nearest_angle(double angle, double near) {
    const double off = angle - near;
    return off > pi ? angle - 2 * pi : (off < -pi ? angle + 2 * pi : angle);
}

// An angle with limits is read within half a turn of the middle of their range, so that it does not
// jump at a limit of half a turn. If little room is left outside the range, that is ambiguous: an
// angle just beyond one limit is one just inside the other. The limit that was last reached then
// decides. Its impulse is positive, and remains at least side_mark while the angle is within
// side_margin of that limit or beyond it.
inline constexpr double ambiguous_range = 2 * pi - 1;  // rad: a range this wide or wider
inline constexpr double side_margin = 1;               // rad: more than a sub-step's rotation
inline constexpr double side_mark = 1e-30;             // N m s: moves nothing
inline bool is_ambiguous(double lower, double upper) {
    return upper - lower > ambiguous_range && upper - lower < 2 * pi + 1e-3;
}
// The angle that readings between the limits stay close to. The impulses are those of the limits.
inline double reference_angle(const JointLimit& limit, double lower_impulse, double upper_impulse) {
    if (!limit.enabled) return 0;
    if (is_ambiguous(limit.lower, limit.upper)) {
        if (upper_impulse > 0) return limit.upper;
        if (lower_impulse > 0) return limit.lower;
    }
    return 0.5 * (limit.lower + limit.upper);
}

}  // namespace jostle::physics
