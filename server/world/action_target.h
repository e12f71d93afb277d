// SPDX-License-Identifier: MIT
//
// Targets of an action of a client, and the objects and energy that it adds: the input of
// permissions, protected areas and quotas of a room. Computed before the action, from the state of
// the world.
#pragma once

#include <cstddef>
#include <optional>

#include "server/world/command.h"
#include "server/world/hosted_state.h"
#include "server/world/room_permissions.h"

namespace jostle::server {

struct ActionTarget {
    RoomAction action;
    TargetOwner owner = TargetOwner::no_target;
    std::optional<physics::Vec3> point = {};
    double radius = 0;
    std::optional<physics::Vec3> second_point = {};  // of a joint
};

// Nothing: the action needs no permission, because it ends something or continues what a permission
// began.
std::optional<ActionTarget> target_of(const HostedState& world, ClientId client,
                                      const Action& action);

// Whether energy_of() may return more than 0.
bool needs_energy(const Action& action);
// J. An estimate: of the speed that the action gives to a body at rest. `affected`: the entity that
// it created.
double energy_of(const HostedState& world, const Action& action, EntityId affected);

struct AddedObjects {
    std::size_t bodies = 0, joints = 0;
};

AddedObjects added_objects(const HostedState& world, ClientId client, const Action& action);

}  // namespace jostle::server
