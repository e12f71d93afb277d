// SPDX-License-Identifier: MIT
//
// Adds and removes the entities of bodies that modules created or destroyed. Does nothing in a
// world without modules, where only actions create and destroy bodies.
#pragma once

#include <vector>

#include "server/world/hosted_state.h"

namespace jostle::server {

// Call it after the scene was built and after each step, before any other use of the entities. A
// body of a module becomes an entity without name and owner. `bodies` is scratch memory.
void sync_module_entities(HostedState& state, std::vector<physics::BodyState>& bodies);

}  // namespace jostle::server
