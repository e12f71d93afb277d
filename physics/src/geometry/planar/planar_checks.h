// SPDX-License-Identifier: MIT
//
// Checks of point sets passed to the planar functions.
#pragma once

#include <span>

#include "jostle/physics/result.h"
#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

// Checks for `least` to `most` finite points within the limits. `name` is the name of the set in
// the error message.
Status check_points(const char* name, std::span<const Vec2> points, std::size_t least,
                    std::size_t most);

}  // namespace jostle::physics::planar
