// SPDX-License-Identifier: MIT
//
// What a shape shows to a flow: the area of its shadow along a direction.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

// m^2; `direction` is unit, in the shape's own frame. Exact for convex shapes; of a compound the
// sum of its children's. Planes, meshes and height fields show nothing.
double projected_area(const Geometry& geometry, Vec3 direction);

}  // namespace jostle::physics
