// SPDX-License-Identifier: MIT
//
// Functions shared by the polygon algorithms.
#pragma once

#include "jostle/physics/polygon.h"

namespace jostle::physics::planar {

// Returns whether a simple polygon is counter-clockwise. Exact.
bool runs_counter_clockwise(std::span<const Vec2> polygon);

// Same as triangulate() for a checked polygon.
Result<std::vector<Triangle>> triangles_of_checked(std::span<const Vec2> polygon);

}  // namespace jostle::physics::planar
