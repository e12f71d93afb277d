// SPDX-License-Identifier: MIT
//
// Who keeps what happens in a world, so that it outlives the process. The world hands over and goes
// on; nothing here may wait.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/world/checkpoint_copier.h"
#include "server/world/journaled_command.h"
#include "server/world/result_queue.h"

namespace jostle::server {

struct WaitingResult {
    std::shared_ptr<ResultQueue> reply;
    InputResult result;
};

struct ExecutedTick {
    std::uint32_t tick = 0;
    bool steps = true;                       // false: the world stands still
    std::vector<JournaledCommand> commands;  // in the order in which they were applied
};

// Of one world. On its thread, but for trouble().
class WorldJournal {
public:
    virtual ~WorldJournal() = default;

    // Any thread: why nothing can be promised to outlive the process now; nothing: it can.
    virtual std::optional<std::string> failure_reason() const = 0;
    // Any thread: the world can be had as it was after this tick and later ones.
    virtual std::uint32_t oldest_tick() const = 0;
    // Each tick once, in order, when its commands have been applied and before its step.
    virtual void append(ExecutedTick tick) = 0;
    // Its frame is out. `step_ms`: what it takes to do it again; the results are to be told when
    // the tick is safe.
    virtual void on_published(double step_ms, std::vector<WaitingResult> results) = 0;
    // A step was cut short: what it came to cannot be computed again.
    virtual void on_interrupted() = 0;
    // Whether the world as it is after this tick should be handed over.
    virtual bool wants_checkpoint() const = 0;
    virtual void write_checkpoint(std::uint32_t tick,
                                  std::shared_ptr<CheckpointCopier> checkpoint_copy) = 0;
    // Any thread: one that was used before, if there is one: it takes a quarter of the time.
    virtual physics::RestorePoint take_spare_restore_point() = 0;
    // The world will not go on in this process: its last moment; nothing when its last step was cut
    // short by that, and is to be done again as a whole.
    virtual void end(std::optional<CheckpointCopy> checkpoint_copy) = 0;
};

class HostedWorld;
struct WorldStart;

// Of all worlds of a process. Any thread.
class WorldPersistence {
public:
    virtual ~WorldPersistence() = default;

    // Before its first tick; when it returns the world itself is kept. unavailable: it cannot be.
    virtual Status open(WorldStart& start) = 0;
    // The world was stopped and is forgotten.
    virtual void drop(const std::string& id) = 0;
    // The world as it was after that tick. not_found: that is not kept.
    virtual Result<HostedWorld> world_at(const std::string& id, std::uint32_t tick) = 0;
    // A world that was stopped, or that an error ended, as it was last kept.
    virtual Result<WorldStart> reload(const std::string& id) = 0;
    // The same, but in its next tick it becomes `then`, which is what world_at() gave of that tick:
    // ticks, ids and inputs are counted on, and what was done in between is kept.
    virtual Result<WorldStart> rewind(const std::string& id, std::uint32_t tick,
                                      HostedWorld then) = 0;
};

}  // namespace jostle::server
