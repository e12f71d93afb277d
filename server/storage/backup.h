// SPDX-License-Identifier: MIT
//
// Backups of a database of worlds: one file with the state after some commit. A finished backup is
// marked as such and needs no head file; a server that opens it writes one.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/storage/sqlite_database.h"

namespace jostle::server {

// Copies an open database with SQLite's online backup: changes written in between through the same
// connection are part of the copy. All functions on the thread that uses the database.
class OnlineBackup {
public:
    // `path` must not exist.
    static Result<std::unique_ptr<OnlineBackup>> begin(SqliteDatabase& source,
                                                       const std::string& path);
    // Deletes an unfinished copy.
    ~OnlineBackup();

    // Copies up to `pages` pages. True: all are copied.
    Result<bool> step(int pages);
    // After the last step: marks the copy as a backup and makes it durable.
    Status finish();

private:
    OnlineBackup(SqliteDatabase copy, std::string path)
        : copy_(std::move(copy)), path_(std::move(path)) {}

    SqliteDatabase copy_;
    std::string path_;
    std::unique_ptr<sqlite3_backup, FreeWith<sqlite3_backup_finish>> backup_;
    bool is_finished_ = false;
};

// The content of a database or backup, as verify_store() found it.
struct StoreReport {
    struct World {
        std::string id, name;
        std::uint32_t last_tick = 0;
        std::uint64_t checkpoints = 0, entries = 0;
    };
    std::vector<World> worlds;
    std::uint64_t commits = 0, written = 0, bytes = 0;  // `written`: seconds since 1970
    bool is_backup = false;
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
