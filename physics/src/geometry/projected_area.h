// SPDX-License-Identifier: MIT
//
// Projected area of a shape along a direction, for drag.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

// Returns the projected area in m^2; `direction` is a unit vector in the shape's local frame. Exact
// for convex shapes, the sum over the children for compounds, zero for planes, meshes and height
// fields.
double projected_area(const Geometry& geometry, Vec3 direction);

}  // namespace jostle::physics
