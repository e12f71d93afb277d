// SPDX-License-Identifier: MIT
//
// Benchmark scenes, on which Jostle is compared with other engines. The catalogue contains nine
// basic ones (bench_pyramid_465 to bench_bullets_1000). bench_pile() creates the pile in any size.
// Their parameters never change, so results of different versions and engines are comparable.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

/// Returns bench_pile_5000 with another number of bodies, above 0. The bodies fall in columns over
/// a square whose area is proportional to the count, 0.02 m^2 per body. The depth of the settled
/// pile is therefore the same for every count.
SceneDescription bench_pile(int count);

}  // namespace jostle::scenes
