// SPDX-License-Identifier: MIT
//
// The state of a hosted world that actions of clients change. On the thread that owns the world.
#pragma once

#include "jostle/physics/world.h"
#include "server/world/attributes.h"
#include "server/world/command.h"
#include "server/world/controller_registry.h"
#include "server/world/entity_registry.h"
#include "server/world/grabs.h"
#include "server/world/joint_owners.h"
#include "server/world/ownership.h"
#include "server/world/players.h"
#include "server/world/scene_budget.h"
#include "server/world/undo_log.h"
#include "server/world/user_messages.h"

namespace jostle::server {

struct HostLimits {
    SceneBudget scene;                     // its bodies_max also limits spawned bodies
    int bodies_owned_max = 50;             // of one client
    int joints_owned_max = 100;            // likewise
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
    JointOwners joint_owners;
    UndoLog undo;
};

// Whose bodies and joints a client may delete and edit.
enum class Reachable { own, any };

// Removes an existing entity together with its owner, grabs, controlling client and attributes. The
// body stays; the caller destroys it, or a module has done so.
void forget_entity(HostedState& state, EntityId id);

}  // namespace jostle::server
