// SPDX-License-Identifier: MIT
//
// Convex shapes as a core and a rounding radius: the core of a sphere is a point, that of a capsule
// a segment. GJK, EPA and SAT operate on cores; the radii are added exactly afterwards.
#pragma once

#include "jostle/physics/hull.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

enum class Core : unsigned char { point, segment, box, cylinder, cone, hull, triangle };

struct Convex {
    Core core = Core::point;
    Vec3 position;
    Mat3 axes;
    double radius = 0;  // of the rounding, m
    // Segment: y is the half length. Box: half extents. Cylinder and cone: x is the radius, y the
    // half length.
    Vec3 size;
    const ConvexHull* hull = nullptr;  // Core::hull
    const Vec3* corner = nullptr;      // Core::triangle: three corners in the local frame
};

// A convex shape relative to `origin`. Differences of large coordinates are taken once, in this
// function.
Convex convex_of(const TransformedShape& shape, Vec3 origin);
Convex triangle_convex(const Vec3 corner[3], Vec3 position, const Mat3& axes);

// Returns the point of the core that is furthest along d (any length).
Vec3 support(const Convex& shape, Vec3 d);

// Returns a point well inside the core.
Vec3 middle_of(const Convex& shape);

// Returns the approximate size of the shape in m. Tolerances are fractions of it.
double size_of(const Convex& shape);

inline bool is_polyhedron(const Convex& shape) {
    return shape.core == Core::box || shape.core == Core::hull || shape.core == Core::triangle;
}

}  // namespace jostle::physics
