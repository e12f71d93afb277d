// SPDX-License-Identifier: MIT
//
// The world that an administrator names. Any thread.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "server/session/play_context.h"

namespace jostle::server {

// An administrator must name the world: defaulting to the first one would be dangerous.
// invalid_argument: the name is empty. not_found: there is no such world.
Result<std::shared_ptr<WorldHost>> find_world(const PlayContext& context, const std::string& name);

}  // namespace jostle::server
