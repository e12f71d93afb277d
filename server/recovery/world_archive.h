// SPDX-License-Identifier: MIT
//
// The persistence of all worlds of a server: opens the database, recovers its worlds, and persists
// the running ones. Outlives the worlds.
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
#include "server/recovery/world_storage_copy.h"
#include "server/storage/sqlite_storage.h"
#include "server/storage/storage_writer.h"
#include "server/world/world_host.h"

namespace jostle::server {

// A client that was connected when the previous process ended.
struct PreviousClient {
    ClientId client = 0;
    std::uint32_t last_sequence = 0;  // of its applied inputs
};

struct PersistedWorld {
    WorldStart start;
    std::vector<PreviousClient> previous_clients;
};

class WorldArchive : public WorldPersistence {
public:
    // Opens the database and recovers its worlds. `file_system`: see SqliteStorageOptions. From now
    // on a fatal signal is counted as a crash of the worlds whose ticks are running; one archive
    // per process. Errors: the database cannot be opened (SqliteStorage::open) or not written to.
    static Result<std::unique_ptr<WorldArchive>> open(const PersistenceSettings& settings,
                                                      const HostLimits& limits, int threads,
                                                      std::function<void()> on_results_sent,
                                                      const char* file_system = nullptr);
    ~WorldArchive() override;

    // Call once: the recovered worlds in order of creation. A world that cannot be recovered as it
    // was is logged and not resumed, and its data stays in the database, unless the damage is
    // accepted (PersistenceSettings::accept_damage).
    std::vector<PersistedWorld> take_worlds() { return std::exchange(loaded_, {}); }
    // 32 random bytes known only to servers with this database.
    const std::string& secret() const { return secret_; }
    // Client ids from here on were never assigned before.
    ClientId first_client() const { return first_client_; }
    // Any thread; never waits. Reports that client ids below `next` were assigned.
    void on_client(ClientId next);

    // Any thread. Why worlds were not resumed; empty: all were.
    const std::optional<std::string>& damage() const { return damage_; }
    // Any thread. Why no world of this name can be created; empty: it can.
    std::optional<std::string> name_conflict(const std::string& name) const;

    // Any thread. Why nothing can be persisted now; empty: no fault.
    std::optional<std::string> failure_reason() const { return writer_->failure_reason(); }
    std::uint64_t failures() const { return writer_->failures(); }
    std::uint64_t bytes_on_disk() const { return writer_->bytes_on_disk(); }
    std::size_t pending_bytes() const { return writer_->pending_bytes(); }
    // Waits until all queued changes are written. Returns false on timeout.
    bool flush(Clock::duration timeout);

    Status open(WorldStart& start) override;
    void drop(const std::string& id) override;
    Result<HostedWorld> world_at(const std::string& id, std::uint32_t tick) override;
    Result<WorldStart> reload(const std::string& id) override;
    Result<WorldStart> rewind(const std::string& id, std::uint32_t tick, HostedWorld past) override;
    Result<std::unique_ptr<PreparedUndo>> prepare_undo(const std::string& id, ClientId client,
                                                       std::uint32_t first_tick) override;
    Result<WorldStart> undo(const std::string& id, PreparedUndo& prepared) override;
    Result<TemporaryFile> back_up() override;
    // Any thread: a copy of the persisted world up to `last_tick`.
    Result<std::unique_ptr<WorldStorage>> copy_of(const std::string& id, std::uint32_t last_tick);

private:
    WorldArchive(const PersistenceSettings& settings, const HostLimits& limits, int threads,
                 std::function<void()> on_results_sent);
    Status read_notes(WorldStorage& storage);
    // While the disk is full or fails, the changes are queued when all worlds are loaded.
    Status write_or_queue(WorldStorage& storage, std::vector<StorageChange> changes);
    void set_aside(const std::string& id, const std::string& name, const std::string& reason);
    Status load_worlds(WorldStorage& storage, const StorageDamage& damage,
                       const std::vector<StoredWorld>& worlds);
    Result<PersistedWorld> load_world(WorldStorage& storage, const StoredWorld& stored);
    // Recovers the world except for commands that crash it.
    Result<RecoveredWorld> recover(WorldStorage& storage, const StoredWorld& stored,
                                   const WorldDefinition& definition, bool portable_only = false);
    // A world of this process that has stopped.
    struct StoppedWorld {
        StoredWorld stored;
        WorldDefinition definition;
        RecoveredWorld found;
        std::vector<std::uint32_t> checkpoints;  // ascending
    };
    Result<StoppedWorld> load_stopped_world(const std::string& id);
    WorldStart start_of(StoppedWorld last);
    // Continues from `next` in the tick after the last one; `why` is its entry in the journal.
    Result<WorldStart> continue_with(StoppedWorld last, HostedWorld next, JournalSegment why);
    struct ArchivedUndo;
    // Replays the ticks that were written since the last replay.
    Status replay_new_ticks(const std::string& id, ArchivedUndo& undo);
    // A copy of the world with checkpoints up to `tick` and the whole journal after them.
    Result<std::unique_ptr<WorldStorageCopy>> copy_since(const std::string& id, std::uint32_t tick);
    void quarantine_tick(const StoredWorld& stored, const JournaledTick& tick);
    std::shared_ptr<WorldJournal> make_journal(const WorldStart& start,
                                               const JournalPosition& position);

    const std::string path_;  // of the database
    const HostLimits limits_;
    const int threads_;
    const bool accepts_damage_;
    const JournalSettings journal_settings_;
    std::unique_ptr<CrashMarkers> marks_;
    std::unique_ptr<StorageWriter> writer_;
    std::unique_ptr<CheckpointWriter> checkpoints_;  // destroyed before the writer
    std::vector<PersistedWorld> loaded_;
    std::vector<StorageChange> delayed_;
    std::optional<std::string> damage_;
    std::string store_damage_;              // empty: none
    std::vector<std::string> names_aside_;  // of worlds that were not resumed
    std::string secret_;
    ClientId first_client_ = 1;
    std::atomic<ClientId> reserved_{1};
};

}  // namespace jostle::server
