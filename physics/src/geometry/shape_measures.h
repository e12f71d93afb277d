// SPDX-License-Identifier: MIT
//
// Measures of shapes: thickness, projected area and displaced volume.
#pragma once

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Thickness of a shape: a body that moves less than this between two tests cannot tunnel.
//
// Returns the radius of a ball that fits inside the shape, m. Zero for surfaces, infinite for
// planes.
double inner_radius_of(const Geometry& geometry);

// Projected area of a shape along a direction, for drag.
//
// Returns the projected area in m^2; `direction` is a unit vector in the shape's local frame. Exact
// for convex shapes, the sum over the children for compounds, zero for planes, meshes and height
// fields.
double projected_area(const Geometry& geometry, Vec3 direction);

// Volume and centre of the part of a shape below a plane, for buoyancy.
struct Displacement {
    double volume = 0;  // m^3
    Vec3 center;        // centre of that volume, m; zero if the volume is zero
};

// Computes the displaced volume. Below means dot(normal, x) <= offset; `normal` is a unit vector;
// both are in the shape's local frame. Closed form for spheres; boxes and hulls are clipped face by
// face; shapes with rotational symmetry are integrated along their axis, accurate to 1e-6 of their
// volume. A compound is the sum of its children. Planes, meshes and height fields displace nothing.
Displacement displacement(const Geometry& geometry, Vec3 normal, double offset);

// Bounding boxes and bounding radii of shapes.
//
// Returns an axis-aligned bounding box of the shape, tight for convex kinds. Not for planes, which
// are infinite.
Aabb bounds_of(const TransformedShape& shape);
// The bounding box of a shape in the frame of another one.
Aabb bounds_in(const TransformedShape& frame, const TransformedShape& shape);

// Returns the distance of the shape's furthest point from its origin, m. Not for planes.
double radius_of(const Geometry& geometry);

}  // namespace jostle::physics
