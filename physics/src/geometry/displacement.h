// SPDX-License-Identifier: MIT
//
// What of a shape lies below a plane: the volume that it displaces, and its centre.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

struct Displacement {
    double volume = 0;  // m^3
    Vec3 center;        // of that volume, m; zero when there is none
};

// Below means dot(normal, x) <= offset; `normal` is unit, both in the shape's own frame. Closed
// forms for spheres; boxes and hulls are cut face by face; what is round about an axis is
// integrated along it, to 1e-6 of its volume. Of a compound the sum of its children's. Planes,
// meshes and height fields displace nothing.
Displacement displacement(const Geometry& geometry, Vec3 normal, double offset);

}  // namespace jostle::physics
