// SPDX-License-Identifier: MIT
//
// What stands on a plane: shared by the experiments and the stress tests.
#pragma once

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

// Boxes on each other, friction 0.5; the lowest first, then the plane.
Scene box_stack(int count, Vec3 half_extents, double mass);

// Two cards that lean against each other, 20 degrees off the vertical.
Scene leaning_cards(double friction);

// A semicircle of 15 wedges, 0.4 m deep, on a plane.
Scene arch(double inner_radius, double outer_radius);

}  // namespace jostle::bench::accuracy
