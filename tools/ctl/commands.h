// SPDX-License-Identifier: MIT
//
// The commands of jostlectl, one function each: call the server and return the text to print.
#pragma once

#include "tools/ctl/command_arguments.h"
#include "tools/ctl/connection.h"
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

Outcome list_worlds(Connection& server, const CommandArguments& arguments);
Outcome create_world(Connection& server, const CommandArguments& arguments);
Outcome delete_world(Connection& server, const CommandArguments& arguments);
Outcome list_clients(Connection& server, const CommandArguments& arguments);
Outcome kick(Connection& server, const CommandArguments& arguments);
Outcome ban(Connection& server, const CommandArguments& arguments);
Outcome unban(Connection& server, const CommandArguments& arguments);
Outcome list_bans(Connection& server, const CommandArguments& arguments);
Outcome pause(Connection& server, const CommandArguments& arguments);
Outcome resume(Connection& server, const CommandArguments& arguments);
Outcome step(Connection& server, const CommandArguments& arguments);
Outcome export_world(Connection& server, const CommandArguments& arguments);
Outcome rewind(Connection& server, const CommandArguments& arguments);
// Undoes the inputs of `client` in the last `undo_seconds` of `world`.
Outcome undo(Connection& server, const CommandArguments& arguments);
// Downloads a backup of the database to `file`.
Outcome backup(Connection& server, const CommandArguments& arguments);
// Removes the bodies that `client` spawned in `world`.
Outcome remove_bodies(Connection& server, const CommandArguments& arguments);
// Players, attributes and messages of `world`.
Outcome list_players(Connection& server, const CommandArguments& arguments);
Outcome set_role(Connection& server, const CommandArguments& arguments);
// Of `target`; "": all attributes.
Outcome get_attributes(Connection& server, const CommandArguments& arguments);
Outcome set_attribute(Connection& server, const CommandArguments& arguments);
Outcome send_message(Connection& server, const CommandArguments& arguments);
Outcome drain(Connection& server, const CommandArguments& arguments);
Outcome profile(Connection& server, const CommandArguments& arguments);

// ---- commands without a server ----

// Compares every row of the database or backup `file` with its digest.
Outcome verify(const CommandArguments& arguments);
// Puts the backup `file` in the place of `database`, which no server may use.
Outcome restore(const CommandArguments& arguments);

}  // namespace jostle::ctl
