// SPDX-License-Identifier: MIT
//
// Commands of jostlectl that inspect and change bodies and joints.
#pragma once

#include "tools/ctl/command_arguments.h"
#include "tools/ctl/connection.h"
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

// The entity, or the joint if it is not 0.
Outcome inspect(Connection& server, const CommandArguments& arguments);
Outcome edit(Connection& server, const CommandArguments& arguments);
Outcome clone(Connection& server, const CommandArguments& arguments);
Outcome create_joint(Connection& server, const CommandArguments& arguments);
Outcome delete_joint(Connection& server, const CommandArguments& arguments);
// The newest action of a client.
Outcome undo_newest(Connection& server, const CommandArguments& arguments);

}  // namespace jostle::ctl
