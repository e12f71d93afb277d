// SPDX-License-Identifier: MIT
//
// What the scenes of the laboratory share.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// What is the same for all, whatever the defaults become.
SceneDescription with_bench_defaults(SceneDescription scene);

// Its top is at height 0.
void add_bench_floor(SceneDescription& scene, double half_width);
// Four walls, 20 m high and 1 m thick, around a square of this inner half width.
void add_bench_walls(SceneDescription& scene, double half_width);

}  // namespace jostle::scenes
