// SPDX-License-Identifier: MIT
//
// The tables of a database of worlds: creates, migrates and checks them, and sums up the digests of
// their rows.
#pragma once

#include <map>
#include <string>

#include "jostle/base/result.h"
#include "server/storage/sqlite_database.h"
#include "server/storage/store_head.h"

namespace jostle::server {

inline constexpr std::uint64_t schema_version = 3;

// The digests of all rows, by world and of the server's notes.
struct RowTotals {
    std::map<std::string, DigestTotal> worlds;
    DigestTotal notes;

    DigestTotal of_all() const;
};
// Reads only the stored digests, not the rows that they describe.
Result<RowTotals> sum_rows(SqliteDatabase& database);

// The head as stored in the database.
struct DatabaseHead {
    StoreHead store;
    bool is_backup = false;                     // a finished backup that no server has opened yet
    std::map<std::string, DigestTotal> worlds;  // of the rows of each world
};
Result<DatabaseHead> read_head(SqliteDatabase& database);

// Acquires the file exclusively and checks that it is a Jostle database of a supported version and
// has an intact structure. Creates the tables of a new file, and those that an older version does
// not have; the head file is written first. `head` contains the head file.
// corrupt_data: also if the head file says that a file without tables was in use.
enum class OpenMode {
    durable,       // commits survive a power failure
    fast,          // commits survive a crash of the process
    only_reading,  // of a database with tables, which is not acquired
};
Status open_schema(SqliteDatabase& database, OpenMode mode, HeadFile& head,
                   const HeadFile::Content& content);

}  // namespace jostle::server
