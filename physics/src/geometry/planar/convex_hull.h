// SPDX-License-Identifier: MIT
//
// Convex hulls of checked points.
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

// Same as convex_hull() in planar.h, without checks. At least one point.
std::vector<Vec2> hull_of_checked(std::span<const Vec2> points);

}  // namespace jostle::physics::planar
