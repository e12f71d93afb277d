// SPDX-License-Identifier: MIT
//
// Shapes as rows of numbers: what a host that has no C++ hands over.
// clients/web/src/shape_numbers.ts writes them. Whether numbers are in range is for the solver to
// say; here they are read, and what ends early or counts further than there are numbers is refused.
//
//   shapes of a body   count, then each: geometry, then how it touches:
//                      friction, restitution, rolling friction, torsional friction, surface
//                      velocity (3), friction rule, restitution rule (Combine, from 0), category,
//                      mask, group, trigger (0 or 1); then density (kg/m^3) and mass (kg; 0: by the
//                      density): how what the body weighs is spread over its shapes
//   geometry           kind, position (3), rotation (4), then by kind
//     1 sphere         radius
//     2 capsule        radius, half length
//     3 box            half extents (3)
//     4 plane          normal (3)
//     5 cylinder       radius, half length
//     6 cone           radius, half length
//     7 hull           count, points (3 each)
//     8 mesh           count, vertices (3 each), count of triangles, corners (3 each)
//     9 height field   columns, rows, spacing x, spacing z, heights, count of holes, cells
//    10 compound       count, geometries; no compounds
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/defs.h"

namespace jostle::client {

// Nothing: they are no shapes.
std::optional<std::vector<physics::ShapeDef>> decode_shapes(std::span<const double> numbers);

}  // namespace jostle::client
