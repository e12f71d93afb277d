// SPDX-License-Identifier: MIT
//
// A command as it was applied to a world. Replaying it on the previous state of the world yields
// the same next state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "server/world/command.h"

namespace jostle::server {

struct JournaledCommand {
    ClientId client = 0;
    std::uint32_t sequence = 0;
    // Its aim is resolved. Nothing: the aim hit nothing, so only the sequence number counts.
    std::optional<Action> action;
};
struct JournaledTick {
    std::uint32_t tick = 0;
    std::vector<JournaledCommand> commands;  // in the order in which they were applied
};

}  // namespace jostle::server
