// SPDX-License-Identifier: MIT
#include "server/storage/sqlite_schema.h"

#include <unistd.h>

#include <ctime>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr std::uint64_t application_id = 0x4a53544c;  // "JSTL"

// The tables by the schema version that introduced them.
constexpr const char* schema_1 = R"(
    CREATE TABLE world(
        id BLOB PRIMARY KEY, name BLOB NOT NULL, epoch INTEGER NOT NULL, engine BLOB NOT NULL,
        settings BLOB NOT NULL, digest BLOB NOT NULL) WITHOUT ROWID;
    CREATE TABLE journal(
        world BLOB NOT NULL REFERENCES world(id) ON DELETE CASCADE, sequence INTEGER NOT NULL,
        epoch INTEGER NOT NULL, first_tick INTEGER NOT NULL, last_tick INTEGER NOT NULL,
        chain BLOB NOT NULL, data BLOB NOT NULL, digest BLOB NOT NULL,
        PRIMARY KEY(world, sequence)) WITHOUT ROWID;
    CREATE TABLE checkpoint(
        world BLOB NOT NULL REFERENCES world(id) ON DELETE CASCADE, tick INTEGER NOT NULL,
        hash INTEGER NOT NULL, sequence INTEGER NOT NULL, exact BLOB NOT NULL,
        portable BLOB NOT NULL, digest BLOB NOT NULL,
        PRIMARY KEY(world, tick));
)";
constexpr const char* schema_2 = R"(
    CREATE TABLE note(name BLOB PRIMARY KEY, value BLOB NOT NULL, digest BLOB NOT NULL)
        WITHOUT ROWID;
)";
constexpr const char* schema_3 = R"(
    CREATE TABLE head(
        one INTEGER PRIMARY KEY CHECK(one = 1), id BLOB NOT NULL, commits INTEGER NOT NULL,
        written INTEGER NOT NULL, is_backup INTEGER NOT NULL, total BLOB NOT NULL);
    CREATE TABLE world_head(world BLOB PRIMARY KEY, total BLOB NOT NULL) WITHOUT ROWID;
)";

// Digests and the head cannot detect every inconsistency of pages.
Status check_structure(SqliteDatabase& database) {
    Result<SqliteStatement> check = database.prepare("PRAGMA integrity_check(1)");
    if (!check.ok()) return check.error();
    const Result<bool> row = check->step();
    if (!row.ok()) return row.error();
    const std::string_view report = *row ? check->bytes(0) : "";
    if (report == "ok") return {};
    return Error{ErrorCode::corrupt_data, "the database is corrupt: " + std::string(report)};
}

// Calls `on_row` for each row of the query; it must not use the database.
template <class OnRow>
Status for_each_row(SqliteDatabase& database, const char* query, const OnRow& on_row) {
    Result<SqliteStatement> rows = database.prepare(query);
    if (!rows.ok()) return rows.error();
    for (;;) {
        const Result<bool> row = rows->step();
        if (!row.ok()) return row.error();
        if (!*row) return {};
        on_row(*rows);
    }
}

Status write_first_head(SqliteDatabase& database, const StoreHead& head, const RowTotals& totals) {
    Result<SqliteStatement> put = database.prepare("INSERT INTO head VALUES(1, ?1, ?2, ?3, 0, ?4)");
    if (!put.ok()) return put.error();
    if (Status s = put->bind(1, head.id)
                       .bind(2, head.commits)
                       .bind(3, head.written)
                       .bind(4, view_of(head.total.value()))
                       .run();
        !s.ok())
        return s;
    Result<SqliteStatement> put_world = database.prepare("INSERT INTO world_head VALUES(?1, ?2)");
    if (!put_world.ok()) return put_world.error();
    for (const auto& [world, total] : totals.worlds)
        if (Status s = put_world->bind(1, world).bind(2, view_of(total.value())).run(); !s.ok())
            return s;
    return {};
}

// The head file is written before the transaction: if the process ends in between, the next one
// finds a head of one commit, and a database without a head that this commit would have created.
Status create_tables(SqliteDatabase& database, std::uint64_t version, HeadFile& file) {
    StoreHead head{.id = std::string(StoreHead::id_bytes, '\0'),
                   .commits = 1,
                   .written = static_cast<std::uint64_t>(std::time(nullptr))};
    if (::getentropy(head.id.data(), head.id.size()) != 0)
        return Error{ErrorCode::unavailable, "the operating system returned no random bytes"};
    std::string tables = "BEGIN IMMEDIATE;";
    if (version < 1) tables += schema_1;
    if (version < 2) tables += schema_2;
    tables += schema_3;
    tables += "PRAGMA application_id = " + std::to_string(application_id) +
              ";PRAGMA user_version = " + std::to_string(schema_version) + ";";
    Status done = database.execute(tables.c_str());
    const Result<RowTotals> totals = done.ok() ? sum_rows(database) : done.error();
    if (totals.ok()) {
        head.total = totals->of_all();
        done = file.write(head);
        if (done.ok()) done = write_first_head(database, head, *totals);
    } else {
        done = totals.error();
    }
    if (done.ok()) done = database.execute("COMMIT");
    if (!done.ok() && database.in_transaction())
        static_cast<void>(database.execute("ROLLBACK").ok());
    return done;
}

}  // namespace

DigestTotal RowTotals::of_all() const {
    DigestTotal all = notes;
    for (const auto& [world, total] : worlds) all.add(view_of(total.value()));
    return all;
}

Result<RowTotals> sum_rows(SqliteDatabase& database) {
    RowTotals totals;
    const auto add = [&](const SqliteStatement& row) {
        totals.worlds[std::string(row.bytes(0))].add(row.bytes(1));
    };
    for (const char* query : {"SELECT id, digest FROM world", "SELECT world, digest FROM journal",
                              "SELECT world, digest FROM checkpoint"})
        if (Status s = for_each_row(database, query, add); !s.ok()) return s.error();
    if (Status s =
            for_each_row(database, "SELECT digest FROM note",
                         [&](const SqliteStatement& row) { totals.notes.add(row.bytes(0)); });
        !s.ok())
        return s.error();
    return totals;
}

Result<DatabaseHead> read_head(SqliteDatabase& database) {
    DatabaseHead head;
    bool is_found = false;
    if (Status s = for_each_row(database, "SELECT id, commits, written, is_backup, total FROM head",
                                [&](const SqliteStatement& row) {
                                    head.store = {.id = std::string(row.bytes(0)),
                                                  .commits = row.number(1),
                                                  .written = row.number(2),
                                                  .total = {}};
                                    head.store.total.add(row.bytes(4));
                                    head.is_backup = row.number(3) != 0;
                                    is_found = row.bytes(0).size() == StoreHead::id_bytes;
                                });
        !s.ok())
        return s.error();
    if (!is_found) return Error{ErrorCode::corrupt_data, "the head of the database is missing"};
    if (Status s = for_each_row(database, "SELECT world, total FROM world_head",
                                [&](const SqliteStatement& row) {
                                    head.worlds[std::string(row.bytes(0))].add(row.bytes(1));
                                });
        !s.ok())
        return s.error();
    return head;
}

Status open_schema(SqliteDatabase& database, OpenMode mode, HeadFile& head,
                   const HeadFile::Content& content) {
    const bool is_reading = mode == OpenMode::only_reading;
    if (Status s = database.execute(is_reading ? "" : "PRAGMA locking_mode = EXCLUSIVE"); !s.ok())
        return s;
    if (Status s = database.execute("PRAGMA trusted_schema = OFF;"
                                    "PRAGMA cell_size_check = ON;"
                                    "PRAGMA foreign_keys = ON;");
        !s.ok())
        return s;
    const Result<std::uint64_t> application = database.number("PRAGMA application_id");
    const Result<std::uint64_t> version = database.number("PRAGMA user_version");
    const Result<std::uint64_t> tables = database.number("SELECT count(*) FROM sqlite_schema");
    for (const auto* read : {&application, &version, &tables})
        if (!read->ok()) {
            if (read->error().code != ErrorCode::unavailable) return read->error();
            return Error{ErrorCode::failed_precondition,
                         "another process has it open, or it cannot be read (" +
                             read->error().message + "); a database belongs to one server"};
        }
    const bool is_new = *tables == 0;
    if (!is_new && *application != application_id)
        return Error{ErrorCode::corrupt_data,
                     "it is an SQLite database, but not a Jostle database"};
    if (*version > schema_version)
        return Error{ErrorCode::corrupt_data,
                     "it was written by a later version of Jostle (schema " +
                         std::to_string(*version) + "; this version supports " +
                         std::to_string(schema_version) + ")"};
    const bool has_head = !is_new && *version >= schema_version;
    if (!has_head && content.exists && (!content.head || content.head->commits > 1))
        return Error{ErrorCode::corrupt_data,
                     (is_new ? std::string("it is missing or empty")
                             : "it is in the state of an older version of Jostle") +
                         ", but " + head.path() + " says that it was in use" +
                         (content.head ? " until " + utc_text(content.head->written) : "") +
                         "; restore a backup, or delete that file to start without it"};
    if (is_reading && !has_head)
        return Error{ErrorCode::corrupt_data,
                     is_new
                         ? "it is empty"
                         : "it was written by an older version of Jostle; a server that opens it "
                           "updates it"};
    if (is_reading) return check_structure(database);
    if (Status s = database.execute(
            mode == OpenMode::durable ? "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"
                                      : "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
        !s.ok())
        return s;
    if (!is_new)
        if (Status s = check_structure(database); !s.ok()) return s;
    return has_head ? Status() : create_tables(database, is_new ? 0 : *version, head);
}

}  // namespace jostle::server
