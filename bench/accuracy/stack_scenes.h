// SPDX-License-Identifier: MIT
//
// Structures on a plane, shared by the experiments and the stress tests.
#pragma once

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

// A stack of boxes with friction 0.5; the lowest one first, then the plane.
Scene box_stack(int count, Vec3 half_extents, double mass);

// Two cards that lean against each other, 20 degrees off the vertical.
Scene leaning_cards(double friction);

// A semicircle of 15 wedges, 0.4 m deep, on a plane.
Scene arch(double inner_radius, double outer_radius);

}  // namespace jostle::bench::accuracy
