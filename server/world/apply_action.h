// SPDX-License-Identifier: MIT
//
// Applies the actions of clients to a world. Edits, clones, joints and undo have files of their
// own, which only apply_action.cpp calls. On the thread that owns the world.
#pragma once

#include "jostle/base/result.h"
#include "server/world/hosted_state.h"

namespace jostle::server {

// Sets `affected` to the entity or joint that the action names or creates, if any, also on error.
// `reachable`: any: the rules of a room allowed the action.
Status apply_action(HostedState& state, ClientId client, const Action& action, Affected& affected,
                    Reachable reachable = Reachable::own);

}  // namespace jostle::server
