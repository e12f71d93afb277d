// SPDX-License-Identifier: MIT
//
// Collision functions of pairs of shape kinds; collide.h selects one.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// A half space against each convex kind: closed forms. a is the plane.
Manifold collide_plane_sphere(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_plane_capsule(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_plane_box(const TransformedShape& a, const TransformedShape& b, double margin);
// Cylinders, cones and hulls.
Manifold collide_plane_convex(const TransformedShape& a, const TransformedShape& b, double margin);

// Spheres and capsules against each other and against boxes: closed forms.
Manifold collide_spheres(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_sphere_capsule(const TransformedShape& a, const TransformedShape& b,
                                double margin);
Manifold collide_capsules(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_box_sphere(const TransformedShape& a, const TransformedShape& b, double margin);
// Returns nullopt if the capsule's segment enters the box or lies above the rim of a face. These
// cases have no closed form.
std::optional<Manifold> collide_box_capsule(const TransformedShape& a, const TransformedShape& b,
                                            double margin);

// Box against box: separating axes, then clipping of the incident face against the reference face
// (Gottschalk 1996 for the fifteen axes; Sutherland and Hodgman 1974 for the clipping).
Manifold collide_boxes(const TransformedShape& a, const TransformedShape& b, double margin,
                       PairCache& cache);

// Collision of two outlines in the plane. Tests the sides of both as separating axes, the cached
// one first, then clips the facing side to the other outline: one or two points.
//
// Supports shapes with an outline (geometry/outline.h) and planes. Normals and points have z = 0.
Manifold collide_planar(const TransformedShape& a, const TransformedShape& b, double margin,
                        PairCache& cache);

}  // namespace jostle::physics
