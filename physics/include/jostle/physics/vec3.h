// SPDX-License-Identifier: MIT
//
// Three-dimensional vectors.
#pragma once

#include "jostle/physics/scalar.h"

namespace jostle::physics {

/// A three-dimensional vector. The unit depends on use and is stated with each declaration.
struct Vec3 {
    double x = 0, y = 0, z = 0;  ///< components

    double& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
    double operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
    bool operator==(const Vec3&) const = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(Vec3 a) {
    return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(Vec3 a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Vec3 operator*(double s, Vec3 a) {
    return a * s;
}
inline Vec3 operator/(Vec3 a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}
inline Vec3& operator+=(Vec3& a, Vec3 b) {
    return a = a + b;
}
inline Vec3& operator-=(Vec3& a, Vec3 b) {
    return a = a - b;
}
inline Vec3& operator*=(Vec3& a, double s) {
    return a = a * s;
}

/// Returns the dot product.
inline double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Returns the cross product.
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Returns the squared length.
inline double length_squared(Vec3 a) {
    return dot(a, a);
}
/// Returns the length.
inline double length(Vec3 a) {
    return square_root(dot(a, a));
}
/// Returns the absolute values of the components.
inline Vec3 abs(Vec3 a) {
    return {absolute(a.x), absolute(a.y), absolute(a.z)};
}
/// Returns the component-wise minimum.
inline Vec3 min(Vec3 a, Vec3 b) {
    return {minimum(a.x, b.x), minimum(a.y, b.y), minimum(a.z, b.z)};
}
/// Returns the component-wise maximum.
inline Vec3 max(Vec3 a, Vec3 b) {
    return {maximum(a.x, b.x), maximum(a.y, b.y), maximum(a.z, b.z)};
}
/// Returns true if all components are finite.
inline bool is_finite(Vec3 a) {
    return is_finite(a.x) && is_finite(a.y) && is_finite(a.z);
}
/// Returns the component-wise product.
inline Vec3 scaled(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Returns the unit vector along a, or `fallback` if a is shorter than 1e-12.
inline Vec3 normalized(Vec3 a, Vec3 fallback = {0, 1, 0}) {
    const double l = length(a);
    return l > 1e-12 ? a * (1 / l) : fallback;
}

}  // namespace jostle::physics
