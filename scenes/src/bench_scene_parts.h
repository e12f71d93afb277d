// SPDX-License-Identifier: MIT
//
// Parts shared by benchmark scenes.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// Sets the world parameters of all benchmark scenes explicitly, independent of the defaults.
SceneDescription with_bench_defaults(SceneDescription scene);

// Adds a floor whose top is at height 0.
void add_bench_floor(SceneDescription& scene, double half_width);
// Adds four walls, 20 m high and 1 m thick, around a square with this inner half width.
void add_bench_walls(SceneDescription& scene, double half_width);

// The figure of the scene bench_ragdolls_40: eleven capsules and ten joints.

// Adds a figure that stands on `feet`, with its arms spread along the x axis of the pose and its
// face towards z.
void add_bench_ragdoll(SceneDescription& scene, const physics::Transform& feet);

}  // namespace jostle::scenes
