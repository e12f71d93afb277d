// SPDX-License-Identifier: MIT
//
// Shapes as lists of numbers, for hosts other than C++.
// clients/web/sdk/src/prediction/shape_encoding.ts writes them. The decoder rejects lists that end
// early or whose counts exceed the list; the solver checks the ranges of the numbers.
//
//   shapes of a body   count, then per shape: geometry, then the material:
//                      friction, restitution, rolling friction, torsional friction, surface
//                      velocity (3), friction rule, restitution rule (Combine, from 0), category,
//                      mask, group, trigger (0 or 1); then density (kg/m^3) and mass (kg; 0: from
//                      the density), which determine how the mass of the body is distributed
//   geometry           kind, position (3), rotation (4), then by kind
//     1 sphere         radius
//     2 capsule        radius, half length
//     3 box            half extents (3)
//     4 plane          normal (3)
//     5 cylinder       radius, half length
//     6 cone           radius, half length
//     7 hull           count, points (3 each)
//     8 mesh           count, vertices (3 each), count of triangles, indices (3 each)
//     9 height field   columns, rows, spacing x, spacing z, heights, count of holes, cells
//    10 compound       count, geometries; no compounds
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/defs.h"

namespace jostle::client {

// Returns nothing if the list is malformed.
std::optional<std::vector<physics::ShapeDef>> decode_shapes(std::span<const double> numbers);

}  // namespace jostle::client
