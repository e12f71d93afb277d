// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Closest points of two segments, as fractions from `a0` and `b0`, 0 to 1. Of parallel segments,
/// the first one is the point at `if_parallel` or the nearest possible one (C. Ericson, Real-Time
/// Collision Detection, 2005, 5.1.9).
inline std::array<double, 2> closest_on_segments(physics::Vec3 a0, physics::Vec3 a1,
                                                 physics::Vec3 b0, physics::Vec3 b1,
                                                 double if_parallel) {
    using physics::clamp, physics::dot;
    const physics::Vec3 d1 = a1 - a0, d2 = b1 - b0, r = a0 - b0;
    const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r);
    if (!(e > 0)) return {a > 0 ? clamp(-c / a, 0, 1) : 0, 0};
    if (!(a > 0)) return {0, clamp(f / e, 0, 1)};
    const double b = dot(d1, d2), determinant = a * e - b * b;
    double s =
        determinant > 1e-12 * a * e ? clamp((b * f - c * e) / determinant, 0, 1) : if_parallel;
    double t = (b * s + f) / e;
    if (t < 0) {
        t = 0;
        s = clamp(-c / a, 0, 1);
    } else if (t > 1) {
        t = 1;
        s = clamp((b - c) / a, 0, 1);
    }
    return {s, t};
}

}  // namespace jostle::modules
