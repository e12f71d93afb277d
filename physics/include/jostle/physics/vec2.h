// SPDX-License-Identifier: MIT
//
// Two-dimensional vectors (planar.h, polygon.h).
#pragma once

#include "jostle/physics/scalar.h"

namespace jostle::physics {

/// A two-dimensional vector. Units depend on use; metres for positions.
struct Vec2 {
    double x = 0, y = 0;  ///< components

    bool operator==(const Vec2&) const = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}
inline Vec2 operator*(Vec2 a, double s) {
    return {a.x * s, a.y * s};
}
/// Returns the dot product.
inline double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// Returns the z component of the cross product: positive if b is to the left of a.
inline double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// Returns the squared length.
inline double length_squared(Vec2 a) {
    return dot(a, a);
}
/// Returns the length.
inline double length(Vec2 a) {
    return square_root(dot(a, a));
}
/// Returns true if both components are finite.
inline bool is_finite(Vec2 a) {
    return is_finite(a.x) && is_finite(a.y);
}

}  // namespace jostle::physics
