// SPDX-License-Identifier: MIT
//
// How a free body turns in a time h: exact rotations about its axes, put together symmetrically
// (J. Touma, J. Wisdom, "Lie-Poisson integrators for rigid body dynamics in the solar system",
// 1994; the splitting by a symmetric top: E. Hairer, Ch. Lubich, G. Wanner, "Geometric numerical
// integration", VII.5). Second order, and the spatial angular momentum is kept exactly: it is the
// input. Reversible: turning by h and by -h leads back.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

// The turn by a rotation vector, by series where it is less than a radian: error below 1e-16.
Quat turn_by(Vec3 rotation_vector);

// One step of Newton's method: exact to rounding for what is nearly unit.
inline Quat nearly_unit(Quat q) {
    const double s = 1.5 - 0.5 * norm_squared(q);
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}

// q: of the principal axes. momentum: angular, in the world's axes.
Quat free_turn(Quat q, Vec3 momentum, Vec3 inverse_moments, double h);
// How fast its axes go round at most by that, rad/s: of a disc twice as fast as it spins.
double turn_rate(Vec3 momentum, Vec3 inverse_moments);

}  // namespace jostle::physics
