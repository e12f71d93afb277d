// SPDX-License-Identifier: MIT
//
// The figure of the scene lab_ragdolls_40: eleven capsules and ten joints.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// Adds a figure that stands on `feet`, with its arms spread along the x axis of the pose and its
// face towards z.
void add_bench_ragdoll(SceneDescription& scene, const physics::Transform& feet);

}  // namespace jostle::scenes
