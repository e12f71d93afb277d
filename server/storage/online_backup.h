// SPDX-License-Identifier: MIT
//
// Copies a database while it is used: a backup is one file with the state after some commit. A
// finished backup is marked as such and needs no head file; a server that opens it writes one.
#pragma once

#include <sqlite3.h>

#include <memory>
#include <string>

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

// Makes a file, or the entries of a folder, survive a power failure.
Status sync_path(const std::string& path);
std::string folder_of(const std::string& path);

}  // namespace jostle::server
