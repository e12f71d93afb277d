// SPDX-License-Identifier: MIT
//
// The queue of commands into a world. Any thread pushes commands; the tick thread takes those that
// are due. Commands come out in order of arrival, join commands before the inputs of their client,
// and leave commands after its earlier inputs.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "server/util/bounded_queue.h"
#include "server/world/command.h"
#include "server/world/scheduled_inputs.h"

namespace jostle::server {

class CommandMailbox {
public:
    // At most `capacity` commands wait for the next tick, and as many for later ones. `on_push`:
    // called on the pushing thread after each command.
    explicit CommandMailbox(std::size_t capacity, std::function<void()> on_push = {})
        : on_push_(std::move(on_push)), commands_(capacity), scheduled_(capacity) {}

    // Any thread. False: the queue is full and the command was not taken.
    bool push(Command command);
    // Any thread; these never block and never fail. The client left, or its connection broke and it
    // may resume.
    void leave(ClientId client, bool retain_bodies);
    void disconnect(ClientId client);
    // Likewise: the client joined or resumed, before its first input.
    void enter(ClientId client, EnterRoom entry);
    // The client joined or resumed: before it pushes its first command.
    void join(ClientId client, JoinCommand join);

    // The tick thread: takes the commands that are due in this tick. The lists are valid until the
    // next call. Entries precede the inputs, and leave commands follow them.
    void take_due(std::uint32_t tick);
    std::span<const Command> entries() const { return taken_entries_; }
    std::span<const Command> inputs() const { return inputs_; }
    std::span<const Command> leave_commands() const { return taken_leave_commands_; }
    // Before the inputs.
    std::span<Command> join_commands() { return taken_joins_; }
    // After the leave commands: clients whose connection broke and that resumed since the last
    // tick.
    std::span<Command> late_join_commands() { return taken_late_joins_; }
    // The tick thread: whether no command waits, for this or a later tick.
    bool is_empty() const;

private:
    void push_leave(Command command);

    const std::function<void()> on_push_;
    BoundedQueue<Command> commands_;
    ScheduledInputs scheduled_;
    std::vector<Command> inputs_, taken_leave_commands_, taken_entries_, taken_joins_,
        taken_late_joins_;
    mutable std::mutex mutex_;
    // A few of each client at most. A late join follows a leave command of the same client.
    std::vector<Command> leave_commands_, entries_, joins_, late_joins_;
    std::size_t joins_before_leaves_ = 0;  // joins_ when take_due() took the leave commands
};

// The queue of input results for one client. The tick thread puts them, and the client's network
// thread takes them. The number of inputs in flight bounds its size, because each accepted input
// yields one result.
class ResultQueue {
public:
    void put(InputResult result) {
        const std::lock_guard lock(mutex_);
        results_.push_back(std::move(result));
    }
    std::vector<InputResult> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(results_, {});
    }

private:
    std::mutex mutex_;
    std::vector<InputResult> results_;
};

}  // namespace jostle::server
