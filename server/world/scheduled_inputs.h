// SPDX-License-Identifier: MIT
//
// Inputs that came before the tick they are meant for (Command::tick). A client that names ticks
// foresees what its inputs do, so they wait here until then: at most 16 ticks. Those of one client
// keep their order. The world's thread alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "server/world/command.h"

namespace jostle::server {

class ScheduledInputs {
public:
    static constexpr std::uint32_t ticks_max = 16;

    // When more than this wait, all that wait are taken at once.
    explicit ScheduledInputs(std::size_t commands_max) : commands_max_(commands_max) {}

    // Leaves in the batch what is for this tick, in order of arrival: what waited for it, then what
    // is new. What those who leave had sent is for this tick, whatever it says.
    void select_due(std::vector<Command>& batch, std::uint32_t tick,
                    std::span<const Command> leave_commands);

private:
    struct Waiting {
        std::uint32_t tick;
        Command command;
    };
    std::uint32_t tick_of(const Command& command, std::uint32_t tick,
                          std::span<const Command> leave_commands) const;

    std::size_t commands_max_;
    std::vector<Waiting> waiting_;  // in order of arrival
    std::vector<Command> now_;      // of select_due(), kept for its memory
};

}  // namespace jostle::server
