// SPDX-License-Identifier: MIT
//
// What an action does to a world: the only place where one becomes a World call. On the thread that
// owns the world.
#pragma once

#include "jostle/base/result.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/controller_registry.h"
#include "server/world/entity_registry.h"
#include "server/world/grabs.h"
#include "server/world/ownership.h"
#include "server/world/scene_budget.h"

namespace jostle::server {

struct HostLimits {
    SceneBudget scene;                     // its bodies_max is of the whole world, later, too
    int bodies_owned_max = 50;             // of one client
    double lag_compensation_ms_max = 400;  // how long ago a client may have seen what it aims at
};

// All that an action may change.
struct HostedState {
    physics::World world;
    HostLimits limits;
    EntityRegistry entities;
    Ownership ownership;
    Grabs grabs;
    ControllerRegistry controllers;
};

// `about` becomes the entity that the action is about, if any, also when it is refused.
Status apply_action(HostedState& state, ClientId client, const Action& action, EntityId& about);

// The entity's body is gone, or will be: whoever held or owned it does so no longer.
void forget_entity(HostedState& state, EntityId id);

}  // namespace jostle::server
