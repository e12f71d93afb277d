// SPDX-License-Identifier: MIT
//
// Stores worlds in one SQLite file with a write-ahead log next to it. Each row has a digest of its
// content: data that changed on disk is reported with the world and the row.
#pragma once

#include <memory>
#include <string>

#include "server/storage/world_storage.h"

namespace jostle::server {

enum class Durability {
    process,  // written data survives a crash of the process
    machine,  // written data also survives a power failure
};

struct SqliteStorageOptions {
    Durability durability = Durability::machine;
    bool create = true;  // create the file, mode 0600, if it does not exist
    // SQLite VFS name; null: the default. For tests of failing disks.
    const char* file_system = nullptr;
};

class SqliteStorage : public WorldStorage {
public:
    // not_found: the file does not exist and `create` is false. failed_precondition: another
    // process has it open. corrupt_data: not a Jostle database, from a later version, or corrupt.
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
