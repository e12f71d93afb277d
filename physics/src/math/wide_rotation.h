// SPDX-License-Identifier: MIT
//
// SIMD rotations and angles on eight lanes (math/wide.h). Errors are of single precision: a few
// 1e-7.
#pragma once

#include "physics/src/math/wide.h"

namespace jostle::physics::JOSTLE_ISA {

struct WideQuat {
    Wide x, y, z, w;
};
JOSTLE_INLINE WideQuat operator*(WideQuat a, WideQuat b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
JOSTLE_INLINE WideQuat conjugate(WideQuat q) {
    return {-q.x, -q.y, -q.z, q.w};
}
// Returns the change of v under the rotation q. Small rotations do not lose precision.
JOSTLE_INLINE Wide3 rotated_by(WideQuat q, Wide3 v) {
    const Wide3 u{q.x, q.y, q.z}, t = cross(u, v) * splat(2);
    return t * q.w + cross(u, t);
}
JOSTLE_INLINE Wide3 rotate(WideQuat q, Wide3 v) {
    return v + rotated_by(q, v);
}
JOSTLE_INLINE Wide3 x_axis(WideQuat q) {
    return {splat(1) - splat(2) * (q.y * q.y + q.z * q.z), splat(2) * (q.x * q.y + q.w * q.z),
            splat(2) * (q.x * q.z - q.w * q.y)};
}
JOSTLE_INLINE Wide3 y_axis(WideQuat q) {
    return {splat(2) * (q.x * q.y - q.w * q.z), splat(1) - splat(2) * (q.x * q.x + q.z * q.z),
            splat(2) * (q.y * q.z + q.w * q.x)};
}
JOSTLE_INLINE Wide3 z_axis(WideQuat q) {
    return {splat(2) * (q.x * q.z + q.w * q.y), splat(2) * (q.y * q.z - q.w * q.x),
            splat(1) - splat(2) * (q.x * q.x + q.y * q.y)};
}

JOSTLE_INLINE Wide3 normalized(Wide3 v, Wide3 fallback) {
    const Wide square = dot(v, v);
    const WideMask long_enough = square > splat(1e-20f);
    const Wide3 unit = v * (splat(1) / root(select(long_enough, square, splat(1))));
    return select(long_enough, unit, fallback);
}

// Returns the quaternion of a rotation vector of any length; its sign is arbitrary. Taylor series
// of sine and cosine up to a quarter turn.
JOSTLE_INLINE WideQuat from_rotation_vector(Wide3 r) {
    const Wide square = dot(r, r) * splat(0.25f);  // square of half the angle
    Wide t2 = square, scale = splat(0.5f);
    constexpr float quarter_turn = 1.5707f;
    const WideMask far = square > splat(quarter_turn * quarter_turn);
    if (lane_bits(far) != 0) {
        // Half turns of the half angle change only the sign of the quaternion.
        constexpr float round = 12582912;  // 1.5 * 2^23: adding it rounds to an integer
        const Wide half = root(square);
        const Wide turns = (half * splat(0.318309886f) + splat(round)) - splat(round);
        const Wide t = (half - turns * splat(3.140625f)) - turns * splat(9.67653589793e-4f);
        t2 = select(far, t * t, t2);
        scale = select(far, t / (half + half), scale);
    }
    constexpr float sine_series[] = {1.f / 362880, -1.f / 5040, 1.f / 120, -1.f / 6, 1.f};
    constexpr float cosine_series[] = {-1.f / 3628800, 1.f / 40320, -1.f / 720,
                                       1.f / 24,       -1.f / 2,    1.f};
    Wide sine = splat(-1.f / 39916800), cosine = splat(1.f / 479001600);
    for (const float k : sine_series) sine = splat(k) + sine * t2;
    for (const float k : cosine_series) cosine = splat(k) + cosine * t2;
    const Wide3 u = r * (sine * scale);
    return {u.x, u.y, u.z, cosine};
}

// Returns the angle of the point (x, y), -pi..pi; 0 at the origin.
JOSTLE_INLINE Wide arc_tangent(Wide y, Wide x) {
    constexpr float pi = 3.14159265f;
    const Wide ax = absolute(x), ay = absolute(y), one = splat(1), zero = splat(0);
    const Wide high = max(ax, ay), low = min(ax, ay);
    Wide t = low / select(high > zero, high, one);
    const WideMask steep = t > splat(0.414213562f);  // tan(pi / 8)
    t = select(steep, (t - one) / (t + one), t);
    const Wide t2 = t * t;
    Wide sum = splat(1.f / 17);
    constexpr float odd[] = {15.f, 13.f, 11.f, 9.f, 7.f, 5.f, 3.f, 1.f};
    for (const float k : odd) sum = splat(1 / k) - t2 * sum;
    Wide angle = select(steep, splat(pi / 4), zero) + t * sum;
    angle = select(ay > ax, splat(pi / 2) - angle, angle);
    angle = select(zero > x, splat(pi) - angle, angle);
    return select(zero > y, -angle, angle);
}

}  // namespace jostle::physics::JOSTLE_ISA
