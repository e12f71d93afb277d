// SPDX-License-Identifier: MIT
//
// Modules may make and remove bodies: the entities of a world follow. Nothing to do in a world
// without modules, where only actions do so.
#pragma once

#include <vector>

#include "server/world/apply_action.h"

namespace jostle::server {

// Before anything else is asked of the entities: after the scene was built and after each step.
// What a module made is an entity of the scene without a name. `bodies` is scratch.
void sync_module_entities(HostedState& state, std::vector<physics::BodyState>& bodies);

}  // namespace jostle::server
