// SPDX-License-Identifier: MIT
//
// The figure of scene f: eleven capsules and ten joints.
#pragma once

#include "speed/scene_description.h"

namespace jostle::bench {

// Adds a figure that stands on `feet` with its arms spread along the x axis of the pose and its
// face towards z.
void add_ragdoll(SceneDescription& scene, const physics::Transform& feet);

}  // namespace jostle::bench
