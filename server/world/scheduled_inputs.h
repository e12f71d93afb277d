// SPDX-License-Identifier: MIT
//
// Inputs that arrived before their scheduled tick (Command::tick). A client that predicts schedules
// its inputs, which wait here for at most 16 ticks. The inputs of one client keep their order. Tick
// thread only.
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

    // If more than `commands_max` commands wait, all of them become due at once.
    explicit ScheduledInputs(std::size_t commands_max) : commands_max_(commands_max) {}

    // Replaces the batch by the inputs that are due in this tick: waiting inputs first, then new
    // ones, each in order of arrival. All inputs of leaving clients are due.
    void select_due(std::vector<Command>& batch, std::uint32_t tick,
                    std::span<const Command> leave_commands);
    bool is_empty() const { return waiting_.empty(); }

private:
    struct Waiting {
        std::uint32_t tick;
        Command command;
    };
    std::uint32_t tick_of(const Command& command, std::uint32_t tick,
                          std::span<const Command> leave_commands) const;

    std::size_t commands_max_;
    std::vector<Waiting> waiting_;  // in order of arrival
    std::vector<Command> now_;      // reused by select_due()
};

}  // namespace jostle::server
