// SPDX-License-Identifier: MIT
//
// Descriptions of worlds for lists and lobbies, and the filters of lists. Any thread.
#pragma once

#include <memory>
#include <vector>

#include "jostle/base/result.h"
#include "server/session/play_context.h"

namespace jostle::v1 {
class WorldFilter;
class WorldInfo;
}  // namespace jostle::v1

namespace jostle::server {

void write_world(v1::WorldInfo& info, const WorldHost& world, const SessionDirectory& sessions);

// invalid_argument: names the field of the filter.
Status check_filter(const v1::WorldFilter& filter);
bool matches(const v1::WorldFilter& filter, const WorldHost& world,
             const SessionDirectory& sessions);
// Whether a list shows the world to this caller: its token opens the world, and the room is listed,
// or the caller is its owner or an administrator.
bool is_listed(const WorldHost& world, const Identity& who);

}  // namespace jostle::server
