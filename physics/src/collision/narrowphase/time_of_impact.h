// SPDX-License-Identifier: MIT
//
// When two moving shapes first touch, with rotation: conservative advancement (Mirtich,
// "Impulse-based dynamic simulation", 1996). Steps forward by the distance over the fastest that
// any two points can close it, so that nothing is ever stepped over.
#pragma once

#include "jostle/physics/aabb.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// A rigid body's motion over a step, as fractions 0..1 of it: even, and about the centre of mass.
struct Sweep {
    double from = 0;  // the fraction at which `center` and `rotation` hold
    Vec3 center;      // m
    Quat rotation;
    Vec3 translation, rotation_vector;  // m, rad over a whole step
    double until = 1;                   // the fraction to which it goes
};
Vec3 center_at(const Sweep& sweep, double fraction);
Quat rotation_at(const Sweep& sweep, double fraction);

struct SweptShape {
    const Geometry* geometry = nullptr;
    Vec3 offset;        // of the shape's origin from the centre of mass, body axes
    Mat3 axes;          // in the body
    double radius = 0;  // m: the body's furthest point from its centre of mass
    Sweep sweep;
    double scale = 1;  // below 1: only this part of the shape, about its middle; children of a
                       // compound each about their own
};
TransformedShape transformed_shape_at(const SweptShape& shape, double fraction);
// Holds the shape from one fraction to another. Not for planes.
Aabb swept_bounds(const SweptShape& shape, double from, double until);

struct Impact {
    static constexpr double never = 2;
    double fraction = never;  // of the step
    Vec3 normal;              // then: unit, from a to b
    Vec3 point;               // m, world, between the surfaces
    bool at_start = false;    // they touched already at `from`
};

// The first fraction from `from` on, while both sweeps last, at which the shapes come within `gap`
// of each other; any kinds. What touches at `from` has no such moment and says at_start; of shapes
// with several parts the others may still have theirs. `until`: later ones are not checked for.
Impact time_of_impact(const SweptShape& a, const SweptShape& b, double from, double gap,
                      double until = 1);

}  // namespace jostle::physics
