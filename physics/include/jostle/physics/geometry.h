// SPDX-License-Identifier: MIT
//
// The shape kinds as plain data, each in its own local frame, sizes in metres.
#pragma once

#include <variant>

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Every length of a shape lies in this range; beyond it masses overflow single precision in the
// contact kernel.
inline constexpr double min_shape_size = 1e-3;  // m
inline constexpr double max_shape_size = 1e4;   // m

struct Sphere {
    double radius = 0.5;

    bool operator==(const Sphere&) const = default;
};

// A segment along the local y axis from -half_length to +half_length, thickened by the radius.
struct Capsule {
    double radius = 0.25;
    double half_length = 0.5;

    bool operator==(const Capsule&) const = default;
};

struct Box {
    Vec3 half_extents{0.5, 0.5, 0.5};

    bool operator==(const Box&) const = default;
};

// Everything below a plane through the local origin is solid. Only static bodies may carry one.
struct Plane {
    Vec3 normal{0, 1, 0};  // unit length after creation

    bool operator==(const Plane&) const = default;
};

using Geometry = std::variant<Sphere, Capsule, Box, Plane>;

enum class ShapeKind { sphere, capsule, box, plane };  // in the order of Geometry's alternatives

inline ShapeKind kind_of(const Geometry& geometry) {
    return static_cast<ShapeKind>(geometry.index());
}

}  // namespace jostle::physics
