// SPDX-License-Identifier: MIT
//
// Commands of jostlectl that inspect and change bodies and joints, and that control the time of a
// room.
#pragma once

#include "tools/ctl/commands.h"

namespace jostle::ctl {

// The entity, or the joint if it is not 0.
Outcome inspect(Connection& server, const CommandArguments& arguments);
Outcome edit(Connection& server, const CommandArguments& arguments);
Outcome clone(Connection& server, const CommandArguments& arguments);
Outcome create_joint(Connection& server, const CommandArguments& arguments);
Outcome delete_joint(Connection& server, const CommandArguments& arguments);
// The newest action of a client.
Outcome undo_newest(Connection& server, const CommandArguments& arguments);
Outcome set_room_speed(Connection& server, const CommandArguments& arguments);
Outcome rewind_room(Connection& server, const CommandArguments& arguments);
// Ticks to which the room can be rewound.
Outcome list_restorable_ticks(Connection& server, const CommandArguments& arguments);
// Writes the settings of the room as JSON, for "room update".
Outcome write_room_settings(Connection& server, const CommandArguments& arguments);
Outcome list_reports(Connection& server, const CommandArguments& arguments);

}  // namespace jostle::ctl
