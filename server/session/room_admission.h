// SPDX-License-Identifier: MIT
//
// Admission to a room by its bans, its join code and its capacity. A world that is no room admits
// everybody. Any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/auth/identity.h"
#include "server/limits/session_directory.h"
#include "server/world/room_command.h"
#include "server/world/world_host.h"

namespace jostle::server {

// The identity of a caller across sessions (RoomClient::member).
std::string member_of(const Identity& who, std::string_view address);
// The entry of a client of this caller.
EnterRoom room_entry(const Identity& who, std::string_view address, bool spectator);

// Whether the caller may join. permission_denied: it is banned, or the join code of a private room
// is wrong. `has_ticket`: its ticket replaces the join code. The owner of the room and
// administrators always may.
Status check_room_access(const WorldHost& world, const Identity& who, std::string_view address,
                         std::string_view join_code, bool has_ticket);
// Clients that the room admits for this caller; 0: unlimited.
std::uint32_t room_capacity(const WorldHost& world, const Identity& who, std::string_view address);
// resource_exhausted: the room has no place for another client.
Status check_room_capacity(const WorldHost& world, const SessionDirectory& sessions,
                           const Identity& who, std::string_view address);

}  // namespace jostle::server
