// SPDX-License-Identifier: MIT
//
// The first touch of two moving, rotating shapes: conservative advancement (Mirtich, "Impulse-based
// dynamic simulation", 1996). Each step advances by the distance divided by the maximum closing
// speed of any two points, so no touch is missed.
#pragma once

#include "jostle/physics/aabb.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// A rigid body's motion over a step, in fractions 0..1: constant velocity and rotation about the
// centre of mass.
struct Sweep {
    double from = 0;  // the fraction at which `center` and `rotation` are valid
    Vec3 center;      // m
    Quat rotation;
    Vec3 translation, rotation_vector;  // m, rad over a whole step
    double until = 1;                   // the fraction at which the motion ends
};
Vec3 center_at(const Sweep& sweep, double fraction);
Quat rotation_at(const Sweep& sweep, double fraction);

struct SweptShape {
    const Geometry* geometry = nullptr;
    Vec3 offset;        // of the shape's origin from the centre of mass, in body axes
    Mat3 axes;          // of the shape in the body
    double radius = 0;  // m: distance of the body's furthest point from its centre of mass
    Sweep sweep;
    // Below 1: only this part of the shape, scaled about its centre. Children of a compound are
    // scaled about their own centres.
    double scale = 1;
};
TransformedShape transformed_shape_at(const SweptShape& shape, double fraction);
// A box that contains the shape from one fraction to another. Not for planes.
Aabb swept_bounds(const SweptShape& shape, double from, double until);

struct Impact {
    static constexpr double never = 2;
    double fraction = never;  // of the step
    Vec3 normal;              // valid if `fraction` is not `never`; unit, from a to b
    Vec3 point;               // m, world, between the surfaces
    bool at_start = false;    // the shapes touched already at `from`
};

// The first fraction from `from` on, while both sweeps last, at which the shapes are within `gap`
// of each other. Supports all kinds. Shapes that touch at `from` have no such fraction and set
// at_start; other parts of composite shapes may still have one. `until`: later touches are ignored.
Impact time_of_impact(const SweptShape& a, const SweptShape& b, double from, double gap,
                      double until = 1);

}  // namespace jostle::physics
