// SPDX-License-Identifier: MIT
//
// Outlines of shapes in a planar world: a convex polygon in the xy plane with rounded corners. A
// sphere is a disc, a capsule a stadium, a hull its projection along z.
#pragma once

#include "jostle/physics/hull.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/mass_properties.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct Outline {
    int count = 0;  // corners: 1 for a point, 2 for a segment, 3 or more for a polygon
    UninitializedArray<Vec3, max_hull_vertices> corner;  // counter-clockwise, z = 0
    double radius = 0;                                   // of the rounding, m
};

inline bool has_outline(ShapeKind kind) {
    return kind == ShapeKind::sphere || kind == ShapeKind::capsule || kind == ShapeKind::box ||
           kind == ShapeKind::hull;
}

// Returns the outline relative to `origin`.
Outline outline_of(const TransformedShape& shape, Vec3 origin);

// Mass properties of a slice 1 m thick: mass = density * area; only the inertia about z is used.
MassProperties planar_mass_of(const Geometry& geometry, double density);

}  // namespace jostle::physics
