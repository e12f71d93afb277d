// SPDX-License-Identifier: MIT
//
// Symmetric 3x3 matrices, for inertia tensors and stiffness.
#pragma once

#include "jostle/physics/mat3.h"

namespace jostle::physics {

struct SymmetricMat3 {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

inline SymmetricMat3 operator+(const SymmetricMat3& a, const SymmetricMat3& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
inline SymmetricMat3 operator*(const SymmetricMat3& m, double s) {
    return {m.xx * s, m.xy * s, m.xz * s, m.yy * s, m.yz * s, m.zz * s};
}
inline Vec3 operator*(const SymmetricMat3& m, Vec3 v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
inline Mat3 to_mat3(const SymmetricMat3& m) {
    return {{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}};
}

// m diag(d) m^T.
inline SymmetricMat3 symmetric_in_axes(const Mat3& m, Vec3 d) {
    const Vec3 x = m.x * d.x, y = m.y * d.y, z = m.z * d.z;
    return {m.x.x * x.x + m.y.x * y.x + m.z.x * z.x, m.x.x * x.y + m.y.x * y.y + m.z.x * z.y,
            m.x.x * x.z + m.y.x * y.z + m.z.x * z.z, m.x.y * x.y + m.y.y * y.y + m.z.y * z.y,
            m.x.y * x.z + m.y.y * y.z + m.z.y * z.z, m.x.z * x.z + m.y.z * y.z + m.z.z * z.z};
}

// Inverts a positive definite matrix. Returns false otherwise.
inline bool invert(const SymmetricMat3& m, SymmetricMat3& to) {
    const double a = m.xx, b = m.xy, c = m.xz, d = m.yy, e = m.yz, f = m.zz;
    const double m0 = d * f - e * e, m1 = c * e - b * f, m2 = b * e - c * d;
    const double determinant = a * m0 + b * m1 + c * m2;
    if (!(a > 0 && a * d - b * b > 0 && determinant > 0)) return false;
    const double s = 1 / determinant;
    to = {m0 * s, m1 * s, m2 * s, (a * f - c * c) * s, (b * c - a * e) * s, (a * d - b * b) * s};
    return true;
}

}  // namespace jostle::physics
