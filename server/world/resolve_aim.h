// SPDX-License-Identifier: MIT
//
// Resolves the aim of an action: casts its ray against the world at the client's view time and
// replaces the aim by the hit entity and the hit point at its current pose. On the thread that owns
// the world.
#pragma once

#include "server/world/apply_action.h"
#include "server/world/frame.h"

namespace jostle::server {

bool has_aim(const Action& action);

// Sets the entity and point, or the centre, of an action with an aim; does nothing without an aim.
// Sets the entity and view_time_clamped of the result. not_found: the ray hits no shape.
Status resolve_aim(const HostedState& state, const FrameRing& past, const EntityList& now,
                   Action& action, InputResult& result);

}  // namespace jostle::server
