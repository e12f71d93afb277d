// SPDX-License-Identifier: MIT
//
// The little of SQLite's interface that a store needs: statements, values in and out, errors as
// ours.
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

    // ?1, ?2 and so on; what is bound lives until the statement is done.
    SqliteStatement& bind(int index, std::string_view bytes);
    SqliteStatement& bind(int index, std::uint64_t number);
    // True: there is a row. False: none is left, and the statement may be run again.
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
    // `make`: the file, if there is none.
    static Result<SqliteDatabase> open(const std::string& path, const char* file_system,
                                       bool create);

    Status execute(const char* statements);
    Result<SqliteStatement> prepare(std::string_view statement);
    Result<std::uint64_t> number(const char* statement);
    // Whether a transaction was begun and not ended, by us or by an error.
    bool in_transaction() const { return sqlite3_get_autocommit(handle_.get()) == 0; }

private:
    explicit SqliteDatabase(sqlite3* handle) : handle_(handle) {}

    std::unique_ptr<sqlite3, FreeWith<sqlite3_close_v2>> handle_;
};

}  // namespace jostle::server
