// SPDX-License-Identifier: MIT
#include "server/world/command_mailbox.h"

#include <algorithm>
#include <utility>

namespace jostle::server {

namespace {

bool has_client(const std::vector<Command>& commands, ClientId client) {
    return std::ranges::any_of(commands, [&](const Command& c) { return c.client == client; });
}

}  // namespace

void CommandMailbox::leave(ClientId client, bool retain_bodies) {
    push_leave({.client = client, .action = LeaveCommand{retain_bodies}, .reply = nullptr});
}

void CommandMailbox::disconnect(ClientId client) {
    push_leave({.client = client, .action = DisconnectCommand{}, .reply = nullptr});
}

void CommandMailbox::join(ClientId client, JoinCommand join) {
    {
        const std::lock_guard lock(mutex_);
        std::vector<Command>& to = has_client(leave_commands_, client) ? late_joins_ : joins_;
        to.push_back({.client = client, .action = std::move(join), .reply = nullptr});
    }
    if (on_push_) on_push_();
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
    }
    if (on_push_) on_push_();
}

void CommandMailbox::push_leave(Command command) {
    {
        const std::lock_guard lock(mutex_);
        std::erase_if(late_joins_, [&](const Command& c) { return c.client == command.client; });
        leave_commands_.push_back(std::move(command));
    }
    if (on_push_) on_push_();
}

bool CommandMailbox::is_empty() const {
    const std::lock_guard lock(mutex_);
    return commands_.size() == 0 && scheduled_.is_empty() && leave_commands_.empty() &&
           joins_.empty() && late_joins_.empty() && entries_.empty();
}

// Takes leave commands first: the earlier inputs of those clients are in the queue by then. Takes
// joins and entries last: clients push inputs after them.
void CommandMailbox::take_due(std::uint32_t tick) {
    taken_leave_commands_.clear();
    taken_joins_.clear();
    taken_late_joins_.clear();
    {
        const std::lock_guard lock(mutex_);
        taken_leave_commands_.swap(leave_commands_);
        taken_late_joins_.swap(late_joins_);
        joins_before_leaves_ = joins_.size();
    }
    commands_.drain_into(inputs_);
    scheduled_.select_due(inputs_, tick, taken_leave_commands_);
    taken_entries_.clear();
    const std::lock_guard lock(mutex_);
    taken_entries_.swap(entries_);
    for (std::size_t k = 0; k < joins_.size(); k++) {
        const bool is_late =
            k >= joins_before_leaves_ && has_client(taken_leave_commands_, joins_[k].client);
        (is_late ? taken_late_joins_ : taken_joins_).push_back(std::move(joins_[k]));
    }
    joins_.clear();
}

}  // namespace jostle::server
