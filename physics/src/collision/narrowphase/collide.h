// SPDX-License-Identifier: MIT
//
// The table: shape kind x shape kind to function.
#pragma once

#include <cstdint>

#include "collision/narrowphase/manifold.h"
#include "geometry/placed.h"

namespace jostle::physics {

// The separating axis that a pair used last; a small preference for it keeps resting pairs from
// flipping between two equally good ones. Part of the world's state.
using AxisCache = std::int8_t;
inline constexpr AxisCache no_axis = -1;

// Points with a gap of at most `margin`. Two planes never collide.
Manifold collide(const Placed& a, const Placed& b, double margin, AxisCache& axis);

}  // namespace jostle::physics
