// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// The point of a triangle nearest to p, found from the Voronoi region (corner, edge or face) that
// contains p (Ericson, "Real-Time Collision Detection", 5.1.5). Triangles of zero area are treated
// as segments or points.
Vec3 nearest_on_triangle(const Vec3 corner[3], Vec3 p);

}  // namespace jostle::physics
