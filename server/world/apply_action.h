// SPDX-License-Identifier: MIT
//
// Applies the actions of clients to a world. Only this file turns an action into World calls. On
// the thread that owns the world.
#pragma once

#include "jostle/base/result.h"
#include "jostle/physics/world.h"
#include "server/world/attributes.h"
#include "server/world/command.h"
#include "server/world/controller_registry.h"
#include "server/world/entity_registry.h"
#include "server/world/grabs.h"
#include "server/world/ownership.h"
#include "server/world/players.h"
#include "server/world/scene_budget.h"
#include "server/world/user_messages.h"

namespace jostle::server {

struct HostLimits {
    SceneBudget scene;                     // its bodies_max also limits spawned bodies
    int bodies_owned_max = 50;             // of one client
    double lag_compensation_ms_max = 400;  // age limit of an aim's view time
    AttributeLimits attributes;
};

// The state that actions change.
struct HostedState {
    physics::World world;
    HostLimits limits;
    EntityRegistry entities;
    Ownership ownership;
    Grabs grabs;
    ControllerRegistry controllers;
    Players players;
    Attributes attributes;
    UserMessages messages;
};

// Sets `affected` to the entity that the action names or creates, if any, also on error.
Status apply_action(HostedState& state, ClientId client, const Action& action, EntityId& affected);

// Removes an existing entity together with its owner, grabs, controlling client and attributes. The
// body stays; the caller destroys it, or a module has done so.
void forget_entity(HostedState& state, EntityId id);

}  // namespace jostle::server
