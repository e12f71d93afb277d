// SPDX-License-Identifier: MIT
//
// Context of the functions that apply actions: the state, the client, and checks for several kinds
// of actions. On the thread that owns the world.
#pragma once

#include <span>
#include <string>

#include "jostle/base/result.h"
#include "server/world/hosted_state.h"

namespace jostle::server {

struct ActionContext {
    HostedState& state;
    ClientId client;
    Affected& affected;
    Reachable reachable = Reachable::own;

    // Whether `count` new bodies, of which one has this pose and these shapes, keep the limits.
    Status check_body_limits(int count, const physics::Transform& pose,
                             std::span<const physics::ShapeDef> shapes) const;
    // A client owns the entity; the server does not.
    void own(EntityId id) const;
    // Adds a step to the undo log of the client.
    void record(UndoStep step) const;
    // Removes an existing entity and its body.
    void remove(EntityId id) const;
};

Error refused(ErrorCode code, std::string message);
Error no_such_entity(EntityId id);
// The solver rejects only invalid numbers.
Status from_solver(const Status& status);

}  // namespace jostle::server
