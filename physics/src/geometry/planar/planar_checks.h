// SPDX-License-Identifier: MIT
//
// Checks of points passed to the planar functions, and the functions that require checked points.
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/polygon.h"
#include "jostle/physics/result.h"
#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

// Checks for `least` to `most` finite points within the limits. `name` is the name of the set in
// the error message.
Status check_points(const char* name, std::span<const Vec2> points, std::size_t least,
                    std::size_t most);

// Same as convex_hull() in planar.h, without checks. At least one point.
std::vector<Vec2> hull_of_checked(std::span<const Vec2> points);

// Returns whether a simple polygon is counter-clockwise. Exact.
bool runs_counter_clockwise(std::span<const Vec2> polygon);

// Same as triangulate() for a checked polygon.
Result<std::vector<Triangle>> triangles_of_checked(std::span<const Vec2> polygon);

}  // namespace jostle::physics::planar
