// SPDX-License-Identifier: MIT
//
// All that outlives a server's process: it opens the store, brings its worlds back, and keeps those
// that run. Outlives the worlds.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/config/config.h"
#include "server/recovery/crash_markers.h"
#include "server/recovery/recover_world.h"
#include "server/recovery/stored_world_journal.h"
#include "server/recovery/world_definition.h"
#include "server/storage/storage_writer.h"
#include "server/world/world_host.h"

namespace jostle::server {

// One that played when the process ended.
struct PreviousClient {
    ClientId client = 0;
    std::uint32_t last_sequence = 0;  // of its inputs that were applied
};

struct PersistedWorld {
    WorldStart start;
    std::vector<PreviousClient> previous_clients;
};

class WorldArchive : public WorldPersistence {
public:
    // `file_system`: SqliteStorageOptions. What is there is read and taken up. From now on a fatal
    // signal is counted for the worlds whose ticks run then, one archive a process. Errors: the
    // store cannot be opened (SqliteStorage::open), or not be written to now.
    static Result<std::unique_ptr<WorldArchive>> open(const PersistenceSettings& settings,
                                                      const HostLimits& limits, int threads,
                                                      std::function<void()> on_results_sent,
                                                      const char* file_system = nullptr);
    ~WorldArchive() override;

    // Once: the worlds that go on, in the order of their creation. One that cannot be had back is
    // told of in the log, and what is there of it stays in the store.
    std::vector<PersistedWorld> take_worlds() { return std::exchange(loaded_, {}); }
    // 32 bytes that only this store's servers know.
    const std::string& secret() const { return secret_; }
    // Ids of clients from here on were never given before.
    ClientId first_client() const { return first_client_; }
    // Any thread; never waits: an id was given, and the next will be that.
    void on_client(ClientId next);

    // Any thread: why nothing can be kept now; nothing: all is well.
    std::optional<std::string> failure_reason() const { return writer_->failure_reason(); }
    std::size_t pending_bytes() const { return writer_->pending_bytes(); }
    // Waits until all is kept that was handed over. False: not within that time.
    bool flush(Clock::duration timeout);

    Status open(WorldStart& start) override;
    void drop(const std::string& id) override;
    Result<HostedWorld> world_at(const std::string& id, std::uint32_t tick) override;
    Result<WorldStart> reload(const std::string& id) override;
    Result<WorldStart> rewind(const std::string& id, std::uint32_t tick, HostedWorld then) override;
    // Any thread: what is kept of a world, up to that tick.
    Result<std::unique_ptr<WorldStorage>> copy_of(const std::string& id, std::uint32_t last_tick);

private:
    WorldArchive(const PersistenceSettings& settings, const HostLimits& limits, int threads,
                 std::function<void()> on_results_sent);
    Status read_notes(WorldStorage& store);
    Status load_worlds(WorldStorage& store, const std::vector<StoredWorld>& worlds);
    Result<PersistedWorld> load_world(WorldStorage& store, const StoredWorld& stored);
    // As it was, but for what crashes it.
    Result<RecoveredWorld> recover(WorldStorage& store, const StoredWorld& stored,
                                   const WorldDefinition& record);
    // One of this process that runs no more.
    struct StoppedWorld {
        StoredWorld stored;
        WorldDefinition record;
        RecoveredWorld found;
        std::vector<std::uint32_t> checkpoints;  // rising
    };
    Result<StoppedWorld> load_stopped_world(const std::string& id);
    WorldStart start_of(StoppedWorld last);
    void quarantine_tick(const StoredWorld& stored, const JournaledTick& tick);
    std::shared_ptr<WorldJournal> make_journal(const WorldStart& start,
                                               const JournalPosition& position);

    const HostLimits limits_;
    const int threads_;
    const JournalSettings journal_settings_;
    std::unique_ptr<CrashMarkers> marks_;
    std::unique_ptr<StorageWriter> writer_;
    std::unique_ptr<CheckpointWriter> checkpoints_;  // before the writer ends
    std::vector<PersistedWorld> loaded_;
    std::string secret_;
    ClientId first_client_ = 1;
    std::atomic<ClientId> reserved_{1};
};

}  // namespace jostle::server
