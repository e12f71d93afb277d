// SPDX-License-Identifier: MIT
#include "server/storage/sqlite_database.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

ErrorCode code_of(int extended) {
    if (extended == SQLITE_IOERR_DATA || extended == SQLITE_IOERR_CORRUPTFS)
        return ErrorCode::corrupt_data;
    if (extended == SQLITE_CONSTRAINT_FOREIGNKEY) return ErrorCode::not_found;
    switch (extended & 0xff) {
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return ErrorCode::corrupt_data;
        case SQLITE_CONSTRAINT:
            return ErrorCode::already_exists;
        case SQLITE_FULL:
            return ErrorCode::resource_exhausted;
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
        case SQLITE_IOERR:
        case SQLITE_CANTOPEN:
        case SQLITE_READONLY:
        case SQLITE_NOMEM:
        case SQLITE_INTERRUPT:
            return ErrorCode::unavailable;
        default:
            // Includes a damaged schema on which our statements fail.
            return ErrorCode::corrupt_data;
    }
}

Error error_of(sqlite3* handle) {
    return {code_of(sqlite3_extended_errcode(handle)), sqlite3_errmsg(handle)};
}

// SQLite would create the file with the permissions of the umask. It also treats a file shorter
// than the smallest page as empty and overwrites it.
Status create_file(const std::string& path, bool create, bool is_read_only) {
    constexpr off_t smallest_page = 512;
    const int access = is_read_only ? O_RDONLY : O_RDWR;
    const int file = ::open(path.c_str(), access | O_CLOEXEC | (create ? O_CREAT : 0), 0600);
    if (file < 0)
        return Error{errno == ENOENT && !create ? ErrorCode::not_found : ErrorCode::unavailable,
                     std::strerror(errno)};
    struct stat about {};
    const bool is_known = ::fstat(file, &about) == 0;
    ::close(file);
    const bool is_short = is_known && about.st_size > 0 && about.st_size < smallest_page;
    // A short file with a rollback journal is valid: SQLite was killed while creating it.
    if (is_short && ::access((path + "-journal").c_str(), F_OK) != 0)
        return Error{ErrorCode::corrupt_data, "file is not a database"};
    return {};
}

}  // namespace

SqliteStatement& SqliteStatement::bind(int index, std::string_view bytes) {
    // Bind an empty blob rather than NULL.
    ASSERT(statement_ && index > 0);
    sqlite3_bind_blob64(statement_.get(), index, bytes.empty() ? "" : bytes.data(), bytes.size(),
                        SQLITE_STATIC);
    return *this;
}

SqliteStatement& SqliteStatement::bind(int index, std::uint64_t number) {
    ASSERT(statement_ && index > 0);
    sqlite3_bind_int64(statement_.get(), index, static_cast<sqlite3_int64>(number));
    return *this;
}

void SqliteStatement::reset() {
    sqlite3_reset(statement_.get());
    sqlite3_clear_bindings(statement_.get());
}

Result<bool> SqliteStatement::step() {
    ASSERT(statement_);
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) {
        reset();
        return false;
    }
    Error error = error_of(sqlite3_db_handle(statement_.get()));
    reset();
    return error;
}

Status SqliteStatement::run() {
    const Result<bool> row = step();
    if (!row.ok()) return row.error();
    if (*row) reset();
    return {};
}

std::string_view SqliteStatement::bytes(int column) const {
    const void* const data = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    ASSERT(size >= 0);
    if (data == nullptr) return {};
    return {static_cast<const char*>(data), static_cast<std::size_t>(size)};
}

std::uint64_t SqliteStatement::number(int column) const {
    return static_cast<std::uint64_t>(sqlite3_column_int64(statement_.get(), column));
}

Result<SqliteDatabase> SqliteDatabase::open(const std::string& path, const char* file_system,
                                            bool create, bool is_read_only) {
    if (Status made = create_file(path, create, is_read_only); !made.ok()) return made.error();
    sqlite3* handle = nullptr;
    const int flags = (is_read_only ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE) |
                      SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_NOFOLLOW;
    const int code = sqlite3_open_v2(path.c_str(), &handle, flags, file_system);
    SqliteDatabase database(handle);
    if (code == SQLITE_OK) return database;
    if (handle == nullptr) return Error{ErrorCode::unavailable, sqlite3_errstr(code)};
    return error_of(handle);
}

Status SqliteDatabase::execute(const char* statements) {
    ASSERT(handle_);
    if (sqlite3_exec(handle_.get(), statements, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
    return error_of(handle_.get());
}

Result<SqliteStatement> SqliteDatabase::prepare(std::string_view statement) {
    ASSERT(handle_);
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v3(handle_.get(), statement.data(), static_cast<int>(statement.size()),
                           SQLITE_PREPARE_PERSISTENT, &prepared, nullptr) != SQLITE_OK)
        return error_of(handle_.get());
    return SqliteStatement(prepared);
}

void SqliteDatabase::empty_log_on_close(bool is_on) {
    sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, is_on ? 0 : 1, nullptr);
}

void SqliteDatabase::empty_log() {
    sqlite3_wal_checkpoint_v2(handle_.get(), nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
}

Result<std::uint64_t> SqliteDatabase::number(const char* statement) {
    Result<SqliteStatement> prepared = prepare(statement);
    if (!prepared.ok()) return prepared.error();
    const Result<bool> row = prepared->step();
    if (!row.ok()) return row.error();
    return *row ? prepared->number(0) : 0;
}

}  // namespace jostle::server
