// SPDX-License-Identifier: MIT
#include "server/world/scheduled_inputs.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

void ScheduledInputs::select_due(std::vector<Command>& batch, std::uint32_t tick,
                                 std::span<const Command> leave_commands) {
    const auto is_later = [&](const Command& command) { return command.tick > tick; };
    if (waiting_.empty() && std::none_of(batch.begin(), batch.end(), is_later)) return;
    const auto has_left = [&](const Waiting& w) {
        return std::any_of(leave_commands.begin(), leave_commands.end(),
                           [&](const Command& l) { return l.client == w.command.client; });
    };
    const bool too_many = waiting_.size() + batch.size() > commands_max_;
    now_.clear();
    std::size_t remaining = 0;
    for (Waiting& w : waiting_) {
        if (too_many || w.tick <= tick || has_left(w))
            now_.push_back(std::move(w.command));
        else if (Waiting& to = waiting_[remaining++]; &to != &w)
            to = std::move(w);
    }
    ASSERT(remaining <= waiting_.size());
    waiting_.resize(remaining);
    for (Command& command : batch) {
        const std::uint32_t at = too_many ? tick : tick_of(command, tick, leave_commands);
        if (at <= tick)
            now_.push_back(std::move(command));
        else
            waiting_.push_back({at, std::move(command)});
    }
    ASSERT(waiting_.size() <= commands_max_);
    batch.swap(now_);
}

// Never before an earlier input of the same client.
std::uint32_t ScheduledInputs::tick_of(const Command& command, std::uint32_t tick,
                                       std::span<const Command> leave_commands) const {
    for (const Command& l : leave_commands)
        if (l.client == command.client) return tick;
    std::uint32_t at = std::clamp(command.tick, tick, tick + ticks_max);
    for (const Waiting& w : waiting_)
        if (w.command.client == command.client) at = std::max(at, w.tick);
    ASSERT(at >= tick);
    return at;
}

}  // namespace jostle::server
