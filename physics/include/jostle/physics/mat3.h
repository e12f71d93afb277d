// SPDX-License-Identifier: MIT
//
// Mat3: three columns. Used for rotations, inertia tensors and effective masses.
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

struct Mat3 {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // columns

    bool operator==(const Mat3&) const = default;
};

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
inline Mat3 transpose(const Mat3& m) {
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
// transpose(m) * v without building the transpose.
inline Vec3 transposed_times(const Mat3& m, Vec3 v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
inline double determinant(const Mat3& m) {
    return dot(m.x, cross(m.y, m.z));
}

// Inverse by cofactors; the zero matrix when m is singular (a body that cannot turn).
inline Mat3 inverse(const Mat3& m) {
    const double det = determinant(m);
    if (det == 0) return diagonal({0, 0, 0});
    const double s = 1 / det;
    return transpose({cross(m.y, m.z) * s, cross(m.z, m.x) * s, cross(m.x, m.y) * s});
}

// The matrix of v -> a x v.
inline Mat3 skew(Vec3 a) {
    return {{0, a.z, -a.y}, {-a.z, 0, a.x}, {a.y, -a.x, 0}};
}

}  // namespace jostle::physics
