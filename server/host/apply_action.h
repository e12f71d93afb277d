// SPDX-License-Identifier: MIT
//
// What an action does to a world: the only place where one becomes a World call. On the thread that
// owns the world.
#pragma once

#include "host/command.h"
#include "host/drivers.h"
#include "host/entity_registry.h"
#include "host/grabs.h"
#include "host/ownership.h"
#include "host/scene_budget.h"
#include "jostle/base/result.h"
#include "jostle/physics/world.h"

namespace jostle::server {

struct HostLimits {
    SceneBudget scene;          // its bodies_max is of the whole world, later, too
    int bodies_owned_max = 50;  // of one client
    double past_ms_max = 400;   // how long ago a client may have seen what it aims at
};

// All that an action may change.
struct HostedState {
    physics::World world;
    HostLimits limits;
    EntityRegistry entities;
    Ownership ownership;
    Grabs grabs;
    Drivers drivers;
};

// `about` becomes the entity that the action is about, if any, also when it is refused.
Status apply_action(HostedState& state, ClientId client, const Action& action, EntityId& about);

// The entity's body is gone, or will be: whoever held or owned it does so no longer.
void forget_entity(HostedState& state, EntityId id);

}  // namespace jostle::server
