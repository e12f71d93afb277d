// SPDX-License-Identifier: MIT
//
// A hosted world as a scene that can be hosted again: what its scene said, as it is now. On the
// thread that owns the world.
#pragma once

#include <string>
#include <vector>

#include "jostle/scenes/scene.h"
#include "server/world/apply_action.h"

namespace jostle::server {

// What the bodies and joints of the scene became when it was built: in its order.
struct SceneIds {
    std::vector<physics::BodyId> bodies;
    std::vector<physics::JointId> joints;
};

struct ExportedScene {
    scenes::SceneDescription scene;
    std::vector<std::string> omitted;  // what a scene cannot say, each as a sentence
};

// `origin`: the scene that the world was made of. Bodies that are gone and joints that broke are
// left out; what clients spawned is there. Impulses and sleep are no part of a scene.
ExportedScene export_scene(HostedState& state, const scenes::SceneDescription& origin,
                           const SceneIds& ids);

}  // namespace jostle::server
