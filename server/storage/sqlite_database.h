// SPDX-License-Identifier: MIT
//
// A minimal wrapper of the SQLite interface: statements, parameters and columns, with
// jostle::Error.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/util/free_with.h"

namespace jostle::server {

class SqliteStatement {
public:
    explicit SqliteStatement(sqlite3_stmt* statement) : statement_(statement) {}

    // Binds ?1, ?2 and so on. Bound bytes must outlive the execution of the statement.
    SqliteStatement& bind(int index, std::string_view bytes);
    SqliteStatement& bind(int index, std::uint64_t number);
    // True: a row is available. False: no more rows; the statement can be executed again.
    Result<bool> step();
    Status run();

    std::string_view bytes(int column) const;
    std::uint64_t number(int column) const;
    void reset();

private:
    std::unique_ptr<sqlite3_stmt, FreeWith<sqlite3_finalize>> statement_;
};

class SqliteDatabase {
public:
    // `create`: create the file if it does not exist.
    static Result<SqliteDatabase> open(const std::string& path, const char* file_system,
                                       bool create, bool is_read_only = false);

    Status execute(const char* statements);
    Result<SqliteStatement> prepare(std::string_view statement);
    Result<std::uint64_t> number(const char* statement);
    // Whether closing the database copies its write-ahead log into it and deletes the log. True
    // when the database is opened.
    void empty_log_on_close(bool is_on);
    // Copies the write-ahead log into the database and empties it, if possible now.
    void empty_log();
    sqlite3* handle() { return handle_.get(); }
    // Whether a transaction is open. Some errors end a transaction.
    bool in_transaction() const { return sqlite3_get_autocommit(handle_.get()) == 0; }

private:
    explicit SqliteDatabase(sqlite3* handle) : handle_(handle) {}

    std::unique_ptr<sqlite3, FreeWith<sqlite3_close_v2>> handle_;
};

}  // namespace jostle::server
