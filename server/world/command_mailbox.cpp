// SPDX-License-Identifier: MIT
#include "server/world/command_mailbox.h"

#include <utility>

namespace jostle::server {

void CommandMailbox::leave(ClientId client, bool retain_bodies) {
    push_leave({.client = client, .action = LeaveCommand{retain_bodies}, .reply = nullptr});
}

void CommandMailbox::disconnect(ClientId client) {
    push_leave({.client = client, .action = DisconnectCommand{}, .reply = nullptr});
}

bool CommandMailbox::push(Command command) {
    if (!commands_.push(std::move(command))) return false;
    if (on_push_) on_push_();
    return true;
}

void CommandMailbox::enter(ClientId client, EnterRoom entry) {
    {
        const std::lock_guard lock(mutex_);
        entries_.push_back(
            {.client = client, .action = RoomCommand{std::move(entry)}, .reply = nullptr});
        has_entries_ = true;
    }
    if (on_push_) on_push_();
}

void CommandMailbox::push_leave(Command command) {
    {
        const std::lock_guard lock(mutex_);
        leave_commands_.push_back(std::move(command));
    }
    if (on_push_) on_push_();
}

bool CommandMailbox::is_empty() const {
    const std::lock_guard lock(mutex_);
    return commands_.size() == 0 && scheduled_.is_empty() && leave_commands_.empty() &&
           entries_.empty();
}

// Takes leave commands first: the earlier inputs of those clients are in the queue by then. Takes
// entries last: those of the clients whose inputs were taken are in the list by then.
void CommandMailbox::take_due(std::uint32_t tick) {
    taken_leave_commands_.clear();
    {
        const std::lock_guard lock(mutex_);
        taken_leave_commands_.swap(leave_commands_);
    }
    commands_.drain_into(inputs_);
    taken_entries_.clear();
    if (has_entries_.exchange(false)) {
        const std::lock_guard lock(mutex_);
        taken_entries_.swap(entries_);
    }
    scheduled_.select_due(inputs_, tick, taken_leave_commands_);
}

}  // namespace jostle::server
