// SPDX-License-Identifier: MIT
//
// Convex shapes as their core and a rounding radius: a sphere is a point, a capsule a segment, both
// thickened. GJK, EPA and SAT work on cores; the radii are put on afterwards, exactly.
#pragma once

#include "jostle/physics/hull.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

enum class Core : unsigned char { point, segment, box, cylinder, cone, hull, triangle };

struct Convex {
    Core core = Core::point;
    Vec3 position;
    Mat3 axes;
    double radius = 0;                 // of the rounding
    Vec3 size;                         // segment: y is its half length; box: half extents;
                                       // cylinder and cone: x is the radius, y the half length
    const ConvexHull* hull = nullptr;  // hull
    const Vec3* corner = nullptr;      // triangle: three corners in its own frame
};

// A convex shape where it stands, seen from `origin` (differences of large coordinates are taken
// once, here).
Convex convex_of(const TransformedShape& shape, Vec3 origin);
Convex triangle_convex(const Vec3 corner[3], Vec3 position, const Mat3& axes);

// The point of the core that lies furthest along d (any length).
Vec3 support(const Convex& shape, Vec3 d);

// A point well inside the core.
Vec3 middle_of(const Convex& shape);

// m: about how large the shape is; tolerances are fractions of it.
double size_of(const Convex& shape);

inline bool is_polyhedron(const Convex& shape) {
    return shape.core == Core::box || shape.core == Core::hull || shape.core == Core::triangle;
}

}  // namespace jostle::physics
