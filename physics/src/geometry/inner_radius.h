// SPDX-License-Identifier: MIT
//
// Thickness of a shape: a body that moves less than this between two tests cannot tunnel.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

// Returns the radius of a ball that fits inside the shape, m. Zero for surfaces, infinite for
// planes.
double inner_radius_of(const Geometry& geometry);

}  // namespace jostle::physics
