// SPDX-License-Identifier: MIT
//
// Decodes and validates the room messages of clients and operators (room.proto, RoomInput of
// play.proto), and encodes room settings. Each error names the invalid field. Pure functions; any
// thread.
#pragma once

#include <string>

#include "jostle/base/result.h"
#include "server/world/room_command.h"
#include "server/world/room_properties.h"
#include "server/world/room_state.h"

namespace jostle::v1 {
class RoomBan;
class RoomInput;
class RoomSettings;
}  // namespace jostle::v1

namespace jostle::server {

Result<RoomProperties> room_from_message(const v1::RoomSettings& message);
// `settings`, in which the fields of `changes` replace those of the same name.
v1::RoomSettings with_changes(v1::RoomSettings settings, const v1::RoomSettings& changes);
// The room settings of a scene file (SceneDescription::room), which are not empty.
Result<v1::RoomSettings> settings_from_scene(const std::string& bytes);
// Entries of `permissions` and `quotas` only where the room differs from a default one. Without the
// join code.
void write_room(v1::RoomSettings& to, const RoomProperties& room);
void write_ban(v1::RoomBan& to, const RoomBan& ban);
// The field Snapshot.room for the clients of a role. Equal rooms have equal bytes.
std::string encode_room_update(const RoomState& room, PlayerRole role);

// The ranges of the values are checked with those of other inputs (limits/admission.h).
Result<RoomCommand> room_command_from_message(const v1::RoomInput& input);

}  // namespace jostle::server
