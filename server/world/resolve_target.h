// SPDX-License-Identifier: MIT
//
// Resolves the target of an action. An aim casts its ray against the shapes of the world at the
// client's view time, and against the present ropes and cloths, and is replaced by what it hits
// first: an entity and a point at its current pose, or a node or vertex. A point object is replaced
// by its node or vertex nearest to the point. On the thread that owns the world.
#pragma once

#include "server/world/frame.h"
#include "server/world/hosted_state.h"
#include "server/world/module_channels.h"

namespace jostle::server {

// Whether resolve_target() has something to do; it may take long in large worlds.
bool has_target(const Action& action);

// Sets the entity and view_time_clamped of the result. not_found: the ray hits nothing, or there is
// no such point object; permission_denied: a cut is aimed at something that cannot be cut.
Status resolve_target(const HostedState& state, const ModuleChannels& channels,
                      const FrameRing& past, const EntityList& now, Action& action,
                      InputResult& result);

}  // namespace jostle::server
