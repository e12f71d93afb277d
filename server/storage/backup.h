// SPDX-License-Identifier: MIT
//
// Verifies databases and backups that no server uses, and restores backups.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/storage/sqlite_storage.h"

namespace jostle::server {

// The content of a database or backup, as verify_store() found it.
struct StoreReport : StoreSummary {
    struct World {
        std::string id, name;
        std::uint32_t last_tick = 0;
        std::uint64_t checkpoints = 0, entries = 0;
    };
    std::vector<World> worlds;
    std::vector<std::string> errors;  // damage, one sentence each
};

// Reads every row of a database that no server uses, and compares it with its digest. Errors: the
// file cannot be opened (SqliteStorage::open).
Result<StoreReport> verify_store(const std::string& path);

// Puts a verified backup in the place of the database `path`, which no server may use. The files of
// the database so far are renamed; their new names are returned. corrupt_data: the backup is
// damaged or is no finished backup. Nothing changes on an error.
Result<std::vector<std::string>> restore_store(const std::string& backup, const std::string& path);

}  // namespace jostle::server
