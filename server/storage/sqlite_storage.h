// SPDX-License-Identifier: MIT
//
// Stores worlds in an SQLite file, a write-ahead log (NAME-wal) and a head file (NAME.head). Each
// row has a digest of its content: data that changed on disk is reported with the world and the
// row. The head file records each commit: a database that lost commits is reported as damage.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/storage/world_storage.h"

namespace jostle::server {

enum class Durability {
    process,  // written data survives a crash of the process
    machine,  // written data also survives a power failure
};

struct SqliteStorageOptions {
    Durability durability = Durability::machine;
    bool create = true;         // create the file, mode 0600, if it does not exist
    bool is_read_only = false;  // changes none of its files; no server may use the database
    // SQLite VFS name; null: the default. For tests of failing disks.
    const char* file_system = nullptr;
};

// How a database differs from its last commit; one sentence each.
struct StorageDamage {
    std::string store;                          // of the whole database; empty: none
    std::map<std::string, std::string> worlds;  // by world id

    bool is_none() const { return store.empty() && worlds.empty(); }
};

class HeadFile;
class OnlineBackup;

struct StoreSummary {
    std::uint64_t commits = 0, written = 0;  // `written`: of the last one, in seconds since 1970
    std::uint64_t bytes = 0;                 // of all files
    bool is_backup = false;                  // a finished backup that no server has opened yet
};

class SqliteStorage : public WorldStorage {
public:
    // not_found: the file does not exist and `create` is false. failed_precondition: another
    // process has it open. corrupt_data: not a Jostle database, from a later version, corrupt, or
    // missing although its head file says that it was in use.
    static Result<std::unique_ptr<SqliteStorage>> open(const std::string& path,
                                                       const SqliteStorageOptions& options);
    ~SqliteStorage() override;

    // As found by open(). A database whose damage().store is not empty can be read but not written
    // (failed_precondition).
    const StorageDamage& damage() const { return damage_; }
    // Makes what can be read the content of a new commit. Rows whose own digest does not match are
    // still reported when they are read.
    Status accept_damage();

    Status write(std::span<const StorageChange> changes) override;
    Result<std::vector<StoredWorld>> worlds() override;
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) override;
    Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) override;
    Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                              std::size_t bytes_max) override;
    Result<std::optional<std::string>> note(const std::string& name) override;
    // Compares each row with its own digest and appends the differences, one sentence each.
    Status check_rows(std::vector<std::string>& errors);
    StoreSummary summary();
    // Begins a copy to a file that does not exist yet.
    Result<std::unique_ptr<OnlineBackup>> begin_backup(const std::string& path);
    Status check_files() override;
    std::uint64_t bytes_on_disk() override;

    using FileId = std::pair<std::uint64_t, std::uint64_t>;  // device and inode

private:
    class Database;
    SqliteStorage(std::string path, std::unique_ptr<Database> database,
                  std::unique_ptr<HeadFile> head_file);
    Status find_damage();

    const std::string path_;
    std::unique_ptr<Database> database_;
    std::unique_ptr<HeadFile> head_file_;
    StorageDamage damage_;
    std::vector<std::pair<std::string, FileId>> files_;  // in use, by path
};

}  // namespace jostle::server
