// SPDX-License-Identifier: MIT
//
// The interfaces for the persistence of worlds, which server/recovery implements. The tick thread
// calls WorldJournal and continues at once, so none of its functions may block.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/util/free_with.h"
#include "server/world/checkpoint_copier.h"
#include "server/world/command.h"
#include "server/world/command_mailbox.h"

namespace jostle::server {

struct WaitingResult {
    std::shared_ptr<ResultQueue> reply;
    InputResult result;
};

struct ExecutedTick {
    std::uint32_t tick = 0;
    bool steps = true;                       // false: the tick took no step
    std::vector<JournaledCommand> commands;  // in order of application
};

// The journal of one world. On its tick thread unless noted.
class WorldJournal {
public:
    virtual ~WorldJournal() = default;

    // Any thread: why inputs cannot be persisted at present; nothing: they can.
    virtual std::optional<std::string> failure_reason() const = 0;
    // Any thread: the oldest tick that can be restored.
    virtual std::uint32_t oldest_tick() const = 0;
    // Each tick once, in order, after its commands were applied and before its step.
    virtual void append(ExecutedTick tick) = 0;
    // After the frame of the tick was published. `step_ms`: the cost of replaying the step. The
    // journal sends the results when the tick is durable.
    virtual void on_published(double step_ms, std::vector<WaitingResult> results) = 0;
    // A step was interrupted, so a replay cannot reproduce its state.
    virtual void on_interrupted() = 0;
    // Whether the state after this tick shall be written.
    virtual bool wants_checkpoint() const = 0;
    virtual void write_checkpoint(std::uint32_t tick, std::shared_ptr<CheckpointCopier> copier) = 0;
    // Any thread: a used restore point, whose capture takes a quarter of the time of a new one; a
    // new one if there is none.
    virtual physics::RestorePoint take_spare_restore_point() = 0;
    // The world ends in this process; the copy has its last state. Nothing: the last step was
    // aborted and will be replayed completely.
    virtual void end(std::optional<CheckpointCopy> checkpoint_copy) = 0;
};

class HostedWorld;
struct WorldStart;

// A file without a name: it is deleted when it is closed.
using TemporaryFile = std::unique_ptr<std::FILE, FreeWith<std::fclose>>;

// An undo that prepare_undo() computed up to a tick of the running world.
struct PreparedUndo {
    virtual ~PreparedUndo() = default;

    std::size_t inputs = 0;  // of the client, undone so far
};

// The database of all worlds of a process. Any thread; these functions may block.
class WorldPersistence {
public:
    virtual ~WorldPersistence() = default;

    // Before the first tick of a world: creates its journal and persists its definition and first
    // checkpoint. unavailable: the database cannot be written.
    virtual Status open(WorldStart& start) = 0;
    // Deletes a stopped world.
    virtual void drop(const std::string& id) = 0;
    // The state of the world after `tick`. not_found: the tick is not in the history.
    virtual Result<HostedWorld> world_at(const std::string& id, std::uint32_t tick) = 0;
    // The last persisted state of a world that was stopped or failed.
    virtual Result<WorldStart> reload(const std::string& id) = 0;
    // Like reload(), but the world continues from `past`, the result of world_at() for `tick`. Tick
    // numbers, entity ids and input sequences continue, and the history in between is retained.
    virtual Result<WorldStart> rewind(const std::string& id, std::uint32_t tick,
                                      HostedWorld past) = 0;
    // Replays the history of a running world without the inputs of `client` from `first_tick` on.
    // not_found: a checkpoint before that tick, or inputs of the client.
    virtual Result<std::unique_ptr<PreparedUndo>> prepare_undo(const std::string& id,
                                                               ClientId client,
                                                               std::uint32_t first_tick) = 0;
    // Like rewind(), but the world continues from the last persisted tick without those inputs.
    virtual Result<WorldStart> undo(const std::string& id, PreparedUndo& prepared) = 0;
    // A backup of all worlds as of now (server/storage/backup.h); the worlds continue meanwhile.
    virtual Result<TemporaryFile> back_up() = 0;
};

}  // namespace jostle::server
