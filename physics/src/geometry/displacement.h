// SPDX-License-Identifier: MIT
//
// Volume and centre of the part of a shape below a plane, for buoyancy.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

struct Displacement {
    double volume = 0;  // m^3
    Vec3 center;        // centre of that volume, m; zero if the volume is zero
};

// Computes the displaced volume. Below means dot(normal, x) <= offset; `normal` is a unit vector;
// both are in the shape's local frame. Closed form for spheres; boxes and hulls are clipped face by
// face; shapes with rotational symmetry are integrated along their axis, accurate to 1e-6 of their
// volume. A compound is the sum of its children. Planes, meshes and height fields displace nothing.
Displacement displacement(const Geometry& geometry, Vec3 normal, double offset);

}  // namespace jostle::physics
