// SPDX-License-Identifier: MIT
//
// The laboratory: scenes on which Jostle and other engines are compared. The catalogue has nine of
// them (lab_pyramid_465 to lab_bullets_1000); the pile is here in any size as well. Their numbers
// never change, so results of different times and engines are about the same scenes.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// lab_pile_5000 with another count, above 0. The bodies fall in columns on a square whose area
// grows with the count, 0.02 m^2 a body. So the pile is as deep for every count when it has
// settled.
SceneDescription bench_pile(int count);

}  // namespace jostle::scenes
