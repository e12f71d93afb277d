// SPDX-License-Identifier: MIT
//
// Bytes of the state of a room, in checkpoints, and of room commands, in the journal. Pure
// functions; any thread. docs/design/format_changes.md lists the versions.
#pragma once

#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/world/room_command.h"
#include "server/world/room_state.h"

namespace jostle::server {

std::string encode_room(const RoomState& room);
// corrupt_data: the bytes are not an encoded room. failed_precondition: they have a version that
// this server does not read.
Result<RoomState> decode_room(std::string_view bytes);

std::string encode_room_command(const RoomCommand& command);
// corrupt_data: the bytes are not an encoded room command.
Result<RoomCommand> decode_room_command(std::string_view bytes);

}  // namespace jostle::server
