// SPDX-License-Identifier: MIT
#include "server/storage/online_backup.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

Status sync_path(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool ok = file >= 0 && ::fsync(file) == 0;
    const int error = errno;
    if (file >= 0) ::close(file);
    if (ok) return {};
    return Error{ErrorCode::unavailable, path + ": " + std::strerror(error)};
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

Result<std::unique_ptr<OnlineBackup>> OnlineBackup::begin(SqliteDatabase& source,
                                                          const std::string& path) {
    if (::access(path.c_str(), F_OK) == 0)
        return Error{ErrorCode::already_exists, path + " exists already"};
    Result<SqliteDatabase> copy = SqliteDatabase::open(path, nullptr, true);
    if (!copy.ok()) return Error{copy.error().code, path + ": " + copy.error().message};
    std::unique_ptr<OnlineBackup> backup(new OnlineBackup(*std::move(copy), path));
    backup->backup_.reset(
        sqlite3_backup_init(backup->copy_.handle(), "main", source.handle(), "main"));
    if (!backup->backup_)
        return Error{ErrorCode::unavailable, path + ": " + sqlite3_errmsg(backup->copy_.handle())};
    return backup;
}

OnlineBackup::~OnlineBackup() {
    backup_.reset();
    if (is_finished_) return;
    ::unlink(path_.c_str());
    ::unlink((path_ + "-journal").c_str());
}

Result<bool> OnlineBackup::step(int pages) {
    ASSERT(backup_ && pages > 0);
    switch (const int code = sqlite3_backup_step(backup_.get(), pages)) {
        case SQLITE_OK:
            return false;
        case SQLITE_DONE:
            return true;
        case SQLITE_FULL:
            return Error{ErrorCode::resource_exhausted, path_ + ": the disk is full"};
        default:
            return Error{ErrorCode::unavailable, path_ + ": " + sqlite3_errstr(code)};
    }
}

Status OnlineBackup::finish() {
    ASSERT(backup_);
    const int code = sqlite3_backup_finish(backup_.release());
    if (code != SQLITE_OK)
        return Error{ErrorCode::unavailable, path_ + ": " + sqlite3_errstr(code)};
    // One file: without a write-ahead log.
    Status done = copy_.execute(
        "PRAGMA journal_mode = DELETE; PRAGMA synchronous = FULL;"
        "UPDATE head SET is_backup = 1");
    if (done.ok()) done = sync_path(folder_of(path_));
    is_finished_ = done.ok();
    return done;
}

}  // namespace jostle::server
