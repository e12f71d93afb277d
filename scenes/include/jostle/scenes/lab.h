// SPDX-License-Identifier: MIT
//
// The laboratory: scenes on which Jostle and other engines are compared. The catalogue has nine of
// them (lab_pyramid_465 to lab_bullets_1000); the pile is here in any size as well. Their numbers
// are fixed for good: results taken at different times, and those of other engines' authors, are
// about the same scenes.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// lab_pile_5000 with another count: the same bodies in columns over a square whose area grows with
// the count (0.02 m^2 a body), so that the settled pile is as deep for every count.
SceneDescription lab_pile(int count);

}  // namespace jostle::scenes
