// SPDX-License-Identifier: MIT
//
// Checks of the points that callers hand to the tools of the plane.
#pragma once

#include <span>

#include "jostle/physics/result.h"
#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

// From `least` to `most` points, finite and within the limits. `name`: what the list is called in
// the error.
Status check_points(const char* name, std::span<const Vec2> points, std::size_t least,
                    std::size_t most);

}  // namespace jostle::physics::planar
