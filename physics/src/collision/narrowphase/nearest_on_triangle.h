// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// The point of a triangle that is nearest to p, by the part of space beside a corner, an edge or
// the face in which p lies (Ericson, "Real-Time Collision Detection", 5.1.5). Triangles without an
// area are segments, or points.
Vec3 nearest_on_triangle(const Vec3 corner[3], Vec3 p);

}  // namespace jostle::physics
