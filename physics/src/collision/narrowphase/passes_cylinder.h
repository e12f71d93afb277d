// SPDX-License-Identifier: MIT
#pragma once

#include "physics/src/geometry/support.h"

namespace jostle::physics {

// Whether a cylinder that goes on square to its axis, as wheels do, has certainly not touched a
// triangle before its middle comes to `middle`: exact but for `margin` m, where a search for the
// nearest points goes to and fro between the two rims. What lies between the planes of its ends is
// looked at along the axis: a polygon of up to five corners, and a disc.
bool passes_cylinder(const Convex& cylinder, Vec3 middle, Vec3 motion, const Vec3 corner[3],
                     double margin);

}  // namespace jostle::physics
