// SPDX-License-Identifier: MIT
//
// What a shape is in a planar world: its outline in the xy plane, a convex polygon with rounded
// corners. A sphere is a disc, a capsule a stadium, a hull the shadow that it throws along z.
#pragma once

#include "jostle/physics/hull.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/mass_properties.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct Outline {
    int count = 0;  // corners: 1 a point, 2 a segment, more a polygon
    UninitializedArray<Vec3, max_hull_vertices> corner;  // counter-clockwise, z = 0
    double radius = 0;                                   // of the rounding
};

inline bool has_outline(ShapeKind kind) {
    return kind == ShapeKind::sphere || kind == ShapeKind::capsule || kind == ShapeKind::box ||
           kind == ShapeKind::hull;
}

// Seen from `origin`.
Outline outline_of(const TransformedShape& shape, Vec3 origin);

// Of a slice 1 m thick: mass = density * area, inertia about z alone counts.
MassProperties planar_mass_of(const Geometry& geometry, double density);

}  // namespace jostle::physics
