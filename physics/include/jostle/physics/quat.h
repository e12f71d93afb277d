// SPDX-License-Identifier: MIT
//
// Rotations as unit quaternions.
#pragma once

#include "jostle/physics/mat3.h"

namespace jostle::physics {

/// A rotation as a unit quaternion x i + y j + z k + w. The default is the identity. Functions that
/// take a rotation expect unit length.
struct Quat {
    double x = 0, y = 0, z = 0, w = 1;  ///< imaginary parts and real part

    bool operator==(const Quat&) const = default;
};

inline Quat operator*(Quat a, Quat b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
/// Returns the inverse rotation.
inline Quat conjugate(Quat q) {
    return {-q.x, -q.y, -q.z, q.w};
}
/// Returns the squared length of q.
inline double norm_squared(Quat q) {
    return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}
/// Returns true if all components are finite.
inline bool is_finite(Quat q) {
    return is_finite(norm_squared(q));
}
/// Returns q scaled to unit length. Precondition: q is not zero.
inline Quat normalized(Quat q) {
    const double s = 1 / square_root(norm_squared(q));
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}
/// Same as normalized(), but returns q unchanged if its length is 1 within rounding. Idempotent:
/// applying it twice does not change a bit.
inline Quat unit(Quat q) {
    return absolute(norm_squared(q) - 1) <= 0x1p-50 ? q : normalized(q);
}

/// Rotates a vector by q.
inline Vec3 rotate(Quat q, Vec3 v) {
    const Vec3 u{q.x, q.y, q.z}, t = cross(u, v) * 2;
    return v + t * q.w + cross(u, t);
}
/// Rotates a vector by the inverse of q.
inline Vec3 inverse_rotate(Quat q, Vec3 v) {
    return rotate(conjugate(q), v);
}

/// Returns the rotation matrix. Its columns are the rotated axes.
inline Mat3 to_matrix(Quat q) {
    const double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    return {{1 - q.y * y2 - q.z * z2, q.x * y2 + q.w * z2, q.x * z2 - q.w * y2},
            {q.x * y2 - q.w * z2, 1 - q.x * x2 - q.z * z2, q.y * z2 + q.w * x2},
            {q.x * z2 + q.w * y2, q.y * z2 - q.w * x2, 1 - q.x * x2 - q.y * y2}};
}

/// Returns the rotation by `angle` radians about `axis`, which has any length except zero.
inline Quat from_axis_angle(Vec3 axis, double angle) {
    const SinCos h = sin_cos(0.5 * angle);
    const Vec3 v = normalized(axis) * h.sin;
    return {v.x, v.y, v.z, h.cos};
}

/// Returns the rotation by the rotation vector r: |r| radians about r (the exponential map of
/// SO(3)). Accurate to rounding for any r.
inline Quat from_rotation_vector(Vec3 r) {
    const double angle2 = length_squared(r);
    if (angle2 < 0.01) {
        // Half-angle series: no division by a small angle, error below 1e-15 in this range.
        const double s =
            0.5 - angle2 * (1.0 / 48 - angle2 * (1.0 / 3840 - angle2 * (1.0 / 645120)));
        const double c = 1 - angle2 * (1.0 / 8 - angle2 * (1.0 / 384 - angle2 * (1.0 / 46080)));
        return normalized(Quat{r.x * s, r.y * s, r.z * s, c});
    }
    return from_axis_angle(r, square_root(angle2));
}

}  // namespace jostle::physics
