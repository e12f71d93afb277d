// SPDX-License-Identifier: MIT
//
// Rotation of a free body over a time h: a symmetric composition of exact rotations about its axes
// (J. Touma, J. Wisdom, "Lie-Poisson integrators for rigid body dynamics in the solar system",
// 1994; the splitting by a symmetric top: E. Hairer, Ch. Lubich, G. Wanner, "Geometric numerical
// integration", VII.5). Second order. The spatial angular momentum is an input, so it is conserved
// exactly. Reversible: rotating by h and then by -h restores the orientation.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

// The rotation by a rotation vector, by a series below one radian: error below 1e-16.
Quat turn_by(Vec3 rotation_vector);

// One step of Newton's method: exact to rounding for a nearly unit quaternion.
inline Quat nearly_unit(Quat q) {
    const double s = 1.5 - 0.5 * norm_squared(q);
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}

// q: orientation of the principal axes. momentum: angular momentum in world axes.
Quat free_turn(Quat q, Vec3 momentum, Vec3 inverse_moments, double h);
// Upper bound of the rotation rate of the axes, rad/s: for a disc, twice its spin.
double turn_rate(Vec3 momentum, Vec3 inverse_moments);

}  // namespace jostle::physics
