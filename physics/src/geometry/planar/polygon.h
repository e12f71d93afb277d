// SPDX-License-Identifier: MIT
//
// What the polygon tools share.
#pragma once

#include "jostle/physics/polygon.h"

namespace jostle::physics::planar {

// Of a simple polygon. Exact.
bool runs_counter_clockwise(std::span<const Vec2> polygon);

// triangulate() of a polygon that has been checked.
Result<std::vector<Triangle>> triangles_of_checked(std::span<const Vec2> polygon);

}  // namespace jostle::physics::planar
