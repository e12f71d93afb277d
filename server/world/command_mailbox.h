// SPDX-License-Identifier: MIT
//
// The commands of clients on their way into a world. Any thread puts them in; the tick thread takes
// those that are due. Commands come out in arrival order, leave commands after the inputs that the
// same client sent before.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "server/util/bounded_queue.h"
#include "server/world/command.h"
#include "server/world/scheduled_inputs.h"

namespace jostle::server {

class CommandMailbox {
public:
    // At most `capacity` commands wait for the next tick, and as many for later ones.
    explicit CommandMailbox(std::size_t capacity) : commands_(capacity), scheduled_(capacity) {}

    // Any thread. False: the queue is full and the command was not taken.
    bool push(Command command) { return commands_.push(std::move(command)); }
    // Any thread; never waits and is never refused. The client left for good, or its connection
    // broke and it may reconnect.
    void leave(ClientId client, bool retain_bodies);
    void disconnect(ClientId client);

    // The tick thread: takes the commands that are due in this tick. The lists are valid until the
    // next call.
    void take_due(std::uint32_t tick);
    std::span<const Command> inputs() const { return inputs_; }
    std::span<const Command> leave_commands() const { return taken_leave_commands_; }

private:
    void push_leave(Command command);

    BoundedQueue<Command> commands_;
    ScheduledInputs scheduled_;
    std::vector<Command> inputs_, taken_leave_commands_;
    std::mutex mutex_;
    std::vector<Command> leave_commands_;  // a few of each client at most
};

}  // namespace jostle::server
