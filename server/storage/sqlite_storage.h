// SPDX-License-Identifier: MIT
//
// Worlds in one SQLite file, with a write-ahead log beside it. Each row carries a digest of all
// that it says: a byte that changed on the disk is reported, with the world and the row that it is
// in.
#pragma once

#include <memory>
#include <string>

#include "server/storage/world_storage.h"

namespace jostle::server {

enum class Durability {
    process,  // what was written survives the process's end, however it ends
    machine,  // ... and that of the machine
};

struct SqliteStorageOptions {
    Durability durability = Durability::machine;
    bool create = true;  // the file, mode 0600, if there is none
    // Of SQLite's own file systems; null: the usual one. For tests of disks that fail.
    const char* file_system = nullptr;
};

class SqliteStorage : public WorldStorage {
public:
    // not_found: there is none, and none is to be made. failed_precondition: another process has it
    // open. corrupt_data: it is not a store of Jostle's, of a later version, or damaged.
    static Result<std::unique_ptr<SqliteStorage>> open(const std::string& path,
                                                       const SqliteStorageOptions& options);
    ~SqliteStorage() override;

    Status write(std::span<const StorageChange> changes) override;
    Result<std::vector<StoredWorld>> worlds() override;
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) override;
    Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) override;
    Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                              std::size_t bytes_max) override;
    Result<std::optional<std::string>> note(const std::string& name) override;

private:
    class Database;
    explicit SqliteStorage(std::unique_ptr<Database> database);

    std::unique_ptr<Database> database_;
};

}  // namespace jostle::server
