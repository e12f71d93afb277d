// SPDX-License-Identifier: MIT
//
// 3x3 matrices for rotations, inertia tensors and effective masses.
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

/// A 3x3 matrix, stored as three columns. The default is the identity.
struct Mat3 {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< columns

    bool operator==(const Mat3&) const = default;
};

/// Returns the diagonal matrix with the elements of d.
inline Mat3 diagonal(Vec3 d) {
    return {{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}};
}
inline Mat3 operator+(const Mat3& a, const Mat3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Mat3 operator-(const Mat3& a, const Mat3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Mat3 operator*(const Mat3& a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Vec3 operator*(const Mat3& m, Vec3 v) {
    return m.x * v.x + m.y * v.y + m.z * v.z;
}
inline Mat3 operator*(const Mat3& a, const Mat3& b) {
    return {a * b.x, a * b.y, a * b.z};
}
/// Returns the transpose of m.
inline Mat3 transpose(const Mat3& m) {
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// Returns transpose(m) * v without computing the transpose.
inline Vec3 transposed_times(const Mat3& m, Vec3 v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
/// Returns the determinant of m.
inline double determinant(const Mat3& m) {
    return dot(m.x, cross(m.y, m.z));
}

/// Returns the inverse of m, computed by cofactors. Returns the zero matrix if m is singular, as
/// for a body that cannot rotate.
inline Mat3 inverse(const Mat3& m) {
    const double det = determinant(m);
    if (det == 0) return diagonal({0, 0, 0});
    const double s = 1 / det;
    return transpose({cross(m.y, m.z) * s, cross(m.z, m.x) * s, cross(m.x, m.y) * s});
}

/// Returns the matrix of the cross product: skew(a) * v = cross(a, v).
inline Mat3 skew(Vec3 a) {
    return {{0, a.z, -a.y}, {-a.z, 0, a.x}, {a.y, -a.x, 0}};
}

}  // namespace jostle::physics
