// SPDX-License-Identifier: MIT
//
// Exports a hosted world as a scene that can be hosted again: its original scene with the current
// state. On the thread that owns the world.
#pragma once

#include <string>
#include <vector>

#include "jostle/scenes/scene.h"
#include "server/world/hosted_state.h"

namespace jostle::server {

// The ids of the bodies and joints that were built from the scene, in its order.
struct SceneIds {
    std::vector<physics::BodyId> bodies;
    std::vector<physics::JointId> joints;
};

struct ExportedScene {
    scenes::SceneDescription scene;
    std::vector<physics::BodyId> bodies;  // of the world, one for each body of the scene
    std::vector<std::string> omitted;     // parts that a scene cannot represent, one sentence each
};

// `origin`: the scene that the world was built from. Removed bodies and broken joints are skipped;
// bodies that clients spawned are included. Accumulated impulses and sleep are not part of a scene.
ExportedScene export_scene(HostedState& state, const scenes::SceneDescription& origin,
                           const SceneIds& ids);

}  // namespace jostle::server
