// SPDX-License-Identifier: MIT
//
// An action that points along a ray becomes one on the entity and the point that the ray meets: as
// the client saw them, brought to where they are now. On the thread that owns the world.
#pragma once

#include "server/world/apply_action.h"
#include "server/world/frame_ring.h"

namespace jostle::server {

bool has_aim(const Action& action);

// Fills entity and point, or centre, of an action with an aim; any other is left as it is. The
// result gets the entity, and whether the moment was clamped. not_found: the ray meets nothing.
Status resolve_aim(const HostedState& state, const FrameRing& past, const EntityList& now,
                   Action& action, InputResult& result);

}  // namespace jostle::server
