// SPDX-License-Identifier: MIT
//
// Hulls of points that have been checked.
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

// As convex_hull() in planar.h. At least one point.
std::vector<Vec2> hull_of_checked(std::span<const Vec2> points);

}  // namespace jostle::physics::planar
