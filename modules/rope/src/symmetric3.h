// SPDX-License-Identifier: MIT
//
// Symmetric 3 x 3 matrices, the blocks of a strand's system.
#pragma once

#include "jostle/physics/mat3.h"

namespace jostle::modules::rope_detail {

struct Symmetric3 {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

inline Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
inline Symmetric3 operator-(const Symmetric3& a, const Symmetric3& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}
inline Symmetric3 operator*(const Symmetric3& a, double s) {
    return {a.xx * s, a.yy * s, a.zz * s, a.xy * s, a.xz * s, a.yz * s};
}
inline physics::Vec3 operator*(const Symmetric3& a, physics::Vec3 v) {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
}
inline Symmetric3 scalar_matrix(double s) {
    return {s, s, s, 0, 0, 0};
}
// s v v^T.
inline Symmetric3 outer(physics::Vec3 v, double s) {
    const physics::Vec3 w = v * s;
    return {v.x * w.x, v.y * w.y, v.z * w.z, v.x * w.y, v.x * w.z, v.y * w.z};
}
inline physics::Mat3 to_matrix(const Symmetric3& a) {
    return {{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}};
}
// The symmetric part of a matrix.
inline Symmetric3 symmetric_part(const physics::Mat3& m) {
    return {
        m.x.x, m.y.y, m.z.z, 0.5 * (m.x.y + m.y.x), 0.5 * (m.x.z + m.z.x), 0.5 * (m.y.z + m.z.y)};
}
// By cofactors. Precondition: positive definite.
inline Symmetric3 inverse(const Symmetric3& a) {
    const double cxx = a.yy * a.zz - a.yz * a.yz, cxy = a.xz * a.yz - a.xy * a.zz,
                 cxz = a.xy * a.yz - a.xz * a.yy;
    const double scale = 1 / (a.xx * cxx + a.xy * cxy + a.xz * cxz);
    return {cxx * scale,
            (a.xx * a.zz - a.xz * a.xz) * scale,
            (a.xx * a.yy - a.xy * a.xy) * scale,
            cxy * scale,
            cxz * scale,
            (a.xy * a.xz - a.xx * a.yz) * scale};
}
// b a b for symmetric a and b.
inline Symmetric3 sandwich(const Symmetric3& b, const Symmetric3& a) {
    return symmetric_part(to_matrix(b) * to_matrix(a) * to_matrix(b));
}

}  // namespace jostle::modules::rope_detail
