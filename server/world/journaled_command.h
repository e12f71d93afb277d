// SPDX-License-Identifier: MIT
//
// A command as it was applied to a world: applied again to the world as it was before, it does the
// same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "server/world/command.h"

namespace jostle::server {

struct JournaledCommand {
    ClientId client = 0;
    std::uint32_t sequence = 0;
    std::optional<Action>
        action;  // without an aim; nothing: it aimed at nothing, and is only counted
};
struct JournaledTick {
    std::uint32_t tick = 0;
    std::vector<JournaledCommand> commands;  // in the order in which they were applied
};

}  // namespace jostle::server
