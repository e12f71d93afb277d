// SPDX-License-Identifier: MIT
//
// How thick a shape is: what moves less than this between two looks cannot have passed through
// anything.
#pragma once

#include "jostle/physics/geometry.h"

namespace jostle::physics {

// m: of a ball that fits inside. Zero for surfaces, infinite for planes.
double inner_radius_of(const Geometry& geometry);

}  // namespace jostle::physics
