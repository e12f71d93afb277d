// SPDX-License-Identifier: MIT
//
// Commands of jostlectl about the room of a world: settings, roles, moderation and time.
#pragma once

#include "tools/ctl/command_arguments.h"
#include "tools/ctl/connection.h"
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

Outcome show_room(Connection& server, const CommandArguments& arguments);
Outcome set_room_role(Connection& server, const CommandArguments& arguments);
Outcome kick_from_room(Connection& server, const CommandArguments& arguments);
Outcome ban_from_room(Connection& server, const CommandArguments& arguments);
Outcome unban_from_room(Connection& server, const CommandArguments& arguments);
Outcome mute(Connection& server, const CommandArguments& arguments);
Outcome clean_up(Connection& server, const CommandArguments& arguments);
Outcome protect(Connection& server, const CommandArguments& arguments);
Outcome unprotect(Connection& server, const CommandArguments& arguments);
Outcome update_room(Connection& server, const CommandArguments& arguments);
Outcome reset(Connection& server, const CommandArguments& arguments);
Outcome set_room_speed(Connection& server, const CommandArguments& arguments);
Outcome rewind_room(Connection& server, const CommandArguments& arguments);
// Ticks to which the room can be rewound.
Outcome list_restorable_ticks(Connection& server, const CommandArguments& arguments);
// Writes the settings of the room as JSON, for "room update".
Outcome write_room_settings(Connection& server, const CommandArguments& arguments);
Outcome list_reports(Connection& server, const CommandArguments& arguments);

}  // namespace jostle::ctl
