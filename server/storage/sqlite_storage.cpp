// SPDX-License-Identifier: MIT
#include "server/storage/sqlite_storage.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "jostle/base/check.h"
#include "server/storage/journal_chain.h"
#include "server/storage/sqlite_database.h"

namespace jostle::server {
namespace {

constexpr std::uint64_t application_id = 0x4a53544c;  // "JSTL"
constexpr std::uint64_t schema_version = 2;

constexpr const char* schema = R"(
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
// Since schema version 2.
constexpr const char* notes_schema = R"(
    CREATE TABLE note(name BLOB PRIMARY KEY, value BLOB NOT NULL, digest BLOB NOT NULL)
        WITHOUT ROWID;
)";

std::string_view view_of(const Digest& digest) {
    return {reinterpret_cast<const char*>(digest.data()), digest.size()};
}

Digest digest_of_row(const StoredWorld& w) {
    const std::string epoch = std::to_string(w.epoch);
    const std::string_view pieces[] = {"world", w.id, w.name, epoch, w.engine, w.settings};
    return digest_of(pieces);
}
Digest digest_of_row(const std::string& world, const JournalEntry& e) {
    const std::string numbers = std::to_string(e.sequence) + " " + std::to_string(e.epoch) + " " +
                                std::to_string(e.first_tick) + " " + std::to_string(e.last_tick);
    const std::string_view pieces[] = {"journal", world, numbers, view_of(e.chain), e.data};
    return digest_of(pieces);
}
Digest digest_of_row(const std::string& world, const Checkpoint& c) {
    const std::string numbers =
        std::to_string(c.tick) + " " + std::to_string(c.hash) + " " + std::to_string(c.sequence);
    const std::string_view pieces[] = {"checkpoint", world, numbers, c.exact, c.portable};
    return digest_of(pieces);
}

Digest digest_of_row(const PutNote& note) {
    const std::string_view pieces[] = {"note", note.name, note.value};
    return digest_of(pieces);
}

Error damaged(const std::string& where) {
    return {ErrorCode::corrupt_data,
            where + " changed after it was written; the disk or the file is corrupt"};
}
std::string name_of(const std::string& world, const JournalEntry& e) {
    return "entry " + std::to_string(e.sequence) + " of the journal of world \"" + world + "\"";
}

}  // namespace

// Prepared statements for repeated use.
class SqliteStorage::Database {
public:
    enum Kind {
        put_world,
        drop_world,
        append,
        digest_of_entry,
        last_sequence,
        put_checkpoint,
        trim_checkpoints,
        trim_journal,
        list_worlds,
        list_checkpoints,
        read_checkpoint,
        list_entries,
        chain_of_entry,
        truncate_checkpoints,
        truncate_journal,
        put_note,
        read_note,
        kinds,
    };

    explicit Database(SqliteDatabase database) : database_(std::move(database)) {}

    Status prepare() {
        static constexpr std::array<const char*, kinds> texts = {
            "INSERT INTO world VALUES(?1, ?2, ?3, ?4, ?5, ?6) ON CONFLICT(id) DO UPDATE SET "
            "name = ?2, epoch = ?3, engine = ?4, settings = ?5, digest = ?6",
            "DELETE FROM world WHERE id = ?1",
            "INSERT INTO journal VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)",
            "SELECT digest FROM journal WHERE world = ?1 AND sequence = ?2",
            "SELECT max(sequence) FROM journal WHERE world = ?1",
            "INSERT OR REPLACE INTO checkpoint VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7)",
            "DELETE FROM checkpoint WHERE world = ?1 AND tick < ?2",
            "DELETE FROM journal WHERE world = ?1 AND sequence < "
            "(SELECT sequence FROM checkpoint WHERE world = ?1 AND tick = ?2)",
            "SELECT id, name, epoch, engine, settings, digest FROM world ORDER BY id",
            "SELECT tick FROM checkpoint WHERE world = ?1 ORDER BY tick DESC",
            "SELECT tick, hash, sequence, exact, portable, digest FROM checkpoint "
            "WHERE world = ?1 AND tick = ?2",
            "SELECT sequence, epoch, first_tick, last_tick, chain, data, digest FROM journal "
            "WHERE world = ?1 AND sequence > ?2 ORDER BY sequence",
            "SELECT chain FROM journal WHERE world = ?1 AND sequence = ?2",
            "DELETE FROM checkpoint WHERE world = ?1 AND tick > ?2",
            "DELETE FROM journal WHERE world = ?1 AND sequence > ?2",
            "INSERT OR REPLACE INTO note VALUES(?1, ?2, ?3)",
            "SELECT value, digest FROM note WHERE name = ?1",
        };
        for (const char* text : texts) {
            Result<SqliteStatement> made = database_.prepare(text);
            if (!made.ok()) return made.error();
            statements_.push_back(*std::move(made));
        }
        return {};
    }

    SqliteDatabase& operator*() { return database_; }
    SqliteDatabase* operator->() { return &database_; }
    SqliteStatement& of(Kind kind) { return statements_[static_cast<std::size_t>(kind)]; }

    // ---- changes ----

    Status operator()(const PutWorld& put) {
        const Digest digest = digest_of_row(put.world);
        return of(put_world)
            .bind(1, put.world.id)
            .bind(2, put.world.name)
            .bind(3, put.world.epoch)
            .bind(4, put.world.engine)
            .bind(5, put.world.settings)
            .bind(6, view_of(digest))
            .run();
    }
    Status operator()(const DropWorld& drop) { return of(drop_world).bind(1, drop.id).run(); }
    Status operator()(const AppendEntry& append_it) {
        const auto& [world, e] = append_it;
        const Digest digest = digest_of_row(world, e);
        SqliteStatement& last = of(last_sequence).bind(1, world);
        const Result<bool> row = last.step();
        if (!row.ok()) return row.error();
        const std::uint64_t newest = last.number(0);
        last.reset();
        if (e.sequence <= newest) return check_duplicate(world, e, digest);
        if (newest != 0 && e.sequence != newest + 1)
            return Error{ErrorCode::not_found,
                         name_of(world, e) + " does not follow entry " + std::to_string(newest)};
        return of(append)
            .bind(1, world)
            .bind(2, e.sequence)
            .bind(3, e.epoch)
            .bind(4, std::uint64_t{e.first_tick})
            .bind(5, std::uint64_t{e.last_tick})
            .bind(6, view_of(e.chain))
            .bind(7, e.data)
            .bind(8, view_of(digest))
            .run();
    }
    Status operator()(const PutCheckpoint& put) {
        const auto& [world, c] = put;
        const Digest digest = digest_of_row(world, c);
        return of(put_checkpoint)
            .bind(1, world)
            .bind(2, std::uint64_t{c.tick})
            .bind(3, c.hash)
            .bind(4, c.sequence)
            .bind(5, c.exact)
            .bind(6, c.portable)
            .bind(7, view_of(digest))
            .run();
    }
    Status operator()(const Trim& trim) {
        for (const Kind kind : {trim_checkpoints, trim_journal})
            if (Status s = of(kind).bind(1, trim.world).bind(2, std::uint64_t{trim.tick}).run();
                !s.ok())
                return s;
        return {};
    }
    Status operator()(const TruncateJournal& truncate) {
        Status done = of(truncate_checkpoints)
                          .bind(1, truncate.world)
                          .bind(2, std::uint64_t{truncate.tick})
                          .run();
        return done.ok()
                   ? of(truncate_journal).bind(1, truncate.world).bind(2, truncate.sequence).run()
                   : done;
    }
    Status operator()(const PutNote& note) {
        const Digest digest = digest_of_row(note);
        return of(put_note).bind(1, note.name).bind(2, note.value).bind(3, view_of(digest)).run();
    }

private:
    // Writing an identical entry again is not an error.
    Status check_duplicate(const std::string& world, const JournalEntry& e, const Digest& digest) {
        SqliteStatement& known = of(digest_of_entry).bind(1, world).bind(2, e.sequence);
        const Result<bool> row = known.step();
        if (!row.ok()) return row.error();
        const bool same = *row && known.bytes(0) == view_of(digest);
        known.reset();
        if (same) return {};
        return Error{ErrorCode::already_exists,
                     name_of(world, e) + " already exists with different content"};
    }

    SqliteDatabase database_;
    std::vector<SqliteStatement> statements_;
};

SqliteStorage::SqliteStorage(std::unique_ptr<Database> database) : database_(std::move(database)) {}
SqliteStorage::~SqliteStorage() = default;

namespace {

Error named(const std::string& path, Error error) {
    error.message = path + ": " + error.message;
    return error;
}

// The digests cannot detect rows that are missing because of a damaged page.
Status check_structure(SqliteDatabase& database) {
    Result<SqliteStatement> check = database.prepare("PRAGMA integrity_check(1)");
    if (!check.ok()) return check.error();
    const Result<bool> row = check->step();
    if (!row.ok()) return row.error();
    const std::string_view report = *row ? check->bytes(0) : "";
    if (report == "ok") return {};
    return Error{ErrorCode::corrupt_data, "the database is corrupt: " + std::string(report)};
}

// Acquires the file exclusively and checks that it has this application's schema version.
Status acquire_file(SqliteDatabase& database, Durability durability) {
    if (Status s = database.execute("PRAGMA locking_mode = EXCLUSIVE;"
                                    "PRAGMA trusted_schema = OFF;"
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
    if (*tables != 0 && *application != application_id)
        return Error{ErrorCode::corrupt_data,
                     "it is an SQLite database, but not a Jostle database"};
    if (*version > schema_version)
        return Error{ErrorCode::corrupt_data,
                     "it was written by a later version of Jostle (schema " +
                         std::to_string(*version) + "; this version supports " +
                         std::to_string(schema_version) + ")"};
    if (Status s =
            database.execute(durability == Durability::machine
                                 ? "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"
                                 : "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
        !s.ok())
        return s;
    if (*tables != 0)
        if (Status s = check_structure(database); !s.ok() || *version == schema_version) return s;
    // Schema version 1 lacks only the notes.
    const std::string create_schema =
        "BEGIN IMMEDIATE;" + std::string(*tables == 0 ? schema : "") + notes_schema +
        "PRAGMA application_id = " + std::to_string(application_id) +
        ";PRAGMA user_version = " + std::to_string(schema_version) + ";COMMIT;";
    return database.execute(create_schema.c_str());
}

}  // namespace

Result<std::unique_ptr<SqliteStorage>> SqliteStorage::open(const std::string& path,
                                                           const SqliteStorageOptions& options) {
    Result<SqliteDatabase> opened = SqliteDatabase::open(path, options.file_system, options.create);
    if (!opened.ok()) return named(path, opened.error());
    if (Status s = acquire_file(*opened, options.durability); !s.ok())
        return named(path, s.error());
    auto database = std::make_unique<Database>(*std::move(opened));
    if (Status s = database->prepare(); !s.ok()) return named(path, s.error());
    return std::unique_ptr<SqliteStorage>(new SqliteStorage(std::move(database)));
}

Status SqliteStorage::write(std::span<const StorageChange> changes) {
    Database& database = *database_;
    Status done = database->execute("BEGIN IMMEDIATE");
    for (const StorageChange& change : changes)
        if (done.ok()) done = std::visit(database, change);
    if (done.ok()) done = database->execute("COMMIT");
    // Some errors have already ended the transaction.
    if (!done.ok() && database->in_transaction()) {
        const Status undone = database->execute("ROLLBACK");
        if (!undone.ok()) return undone;
    }
    return done;
}

Result<std::vector<StoredWorld>> SqliteStorage::worlds() {
    std::vector<StoredWorld> all;
    SqliteStatement& list = database_->of(Database::list_worlds);
    for (;;) {
        const Result<bool> row = list.step();
        if (!row.ok()) return row.error();
        if (!*row) return all;
        StoredWorld world{.id = std::string(list.bytes(0)),
                          .name = std::string(list.bytes(1)),
                          .epoch = list.number(2),
                          .engine = std::string(list.bytes(3)),
                          .settings = std::string(list.bytes(4))};
        if (list.bytes(5) != view_of(digest_of_row(world))) {
            list.reset();
            return damaged("world \"" + world.id + "\"");
        }
        all.push_back(std::move(world));
    }
}

Result<std::vector<std::uint32_t>> SqliteStorage::checkpoint_ticks(const std::string& world) {
    std::vector<std::uint32_t> ticks;
    SqliteStatement& list = database_->of(Database::list_checkpoints).bind(1, world);
    for (;;) {
        const Result<bool> row = list.step();
        if (!row.ok()) return row.error();
        if (!*row) return ticks;
        ticks.push_back(static_cast<std::uint32_t>(list.number(0)));
    }
}

Result<Checkpoint> SqliteStorage::checkpoint(const std::string& world, std::uint32_t tick) {
    const std::string where =
        "the checkpoint of tick " + std::to_string(tick) + " of world \"" + world + "\"";
    SqliteStatement& read =
        database_->of(Database::read_checkpoint).bind(1, world).bind(2, std::uint64_t{tick});
    const Result<bool> row = read.step();
    if (!row.ok()) return row.error();
    if (!*row) return Error{ErrorCode::not_found, where + " does not exist"};
    Checkpoint found{.tick = static_cast<std::uint32_t>(read.number(0)),
                     .hash = read.number(1),
                     .sequence = read.number(2),
                     .exact = std::string(read.bytes(3)),
                     .portable = std::string(read.bytes(4))};
    const bool intact = read.bytes(5) == view_of(digest_of_row(world, found));
    read.reset();
    if (!intact) return damaged(where);
    return found;
}

Result<std::vector<JournalEntry>> SqliteStorage::entries(const std::string& world,
                                                         std::uint64_t after,
                                                         std::size_t bytes_max) {
    std::optional<Chain> previous_chain;
    if (after == 0) previous_chain = Chain{};
    SqliteStatement& chain = database_->of(Database::chain_of_entry).bind(1, world).bind(2, after);
    const Result<bool> known = chain.step();
    if (!known.ok()) return known.error();
    if (*known && chain.bytes(0).size() == sizeof(Chain)) {
        previous_chain.emplace();
        std::copy_n(chain.bytes(0).begin(), sizeof(Chain), previous_chain->begin());
    }
    chain.reset();

    std::vector<JournalEntry> found;
    std::size_t bytes = 0;
    SqliteStatement& list = database_->of(Database::list_entries).bind(1, world).bind(2, after);
    const auto fail = [&](Error error) {
        list.reset();
        return error;
    };
    for (;;) {
        const Result<bool> row = list.step();
        if (!row.ok()) return row.error();
        if (!*row) return found;
        JournalEntry e{.sequence = list.number(0),
                       .epoch = list.number(1),
                       .first_tick = static_cast<std::uint32_t>(list.number(2)),
                       .last_tick = static_cast<std::uint32_t>(list.number(3)),
                       .data = std::string(list.bytes(5))};
        if (list.bytes(4).size() == sizeof(Chain))
            std::copy_n(list.bytes(4).begin(), sizeof(Chain), e.chain.begin());
        bytes += e.data.size();
        if (!found.empty() && bytes > bytes_max) {
            list.reset();
            return found;
        }
        if (list.bytes(6) != view_of(digest_of_row(world, e)))
            return fail(damaged(name_of(world, e)));
        if (e.sequence != after + 1)
            return fail({ErrorCode::corrupt_data, name_of(world, e) + ": the preceding entry " +
                                                      std::to_string(after + 1) + " is missing"});
        if (previous_chain && e.chain != next_chain(*previous_chain, e.data))
            return fail({ErrorCode::corrupt_data,
                         name_of(world, e) + " does not match the chain of the previous entry"});
        previous_chain = e.chain;
        after = e.sequence;
        ASSERT(after == e.sequence);
        found.push_back(std::move(e));
    }
}

Result<std::optional<std::string>> SqliteStorage::note(const std::string& name) {
    SqliteStatement& read = database_->of(Database::read_note).bind(1, name);
    const Result<bool> row = read.step();
    if (!row.ok()) return row.error();
    if (!*row) return std::optional<std::string>();
    PutNote found{name, std::string(read.bytes(0))};
    const bool intact = read.bytes(1) == view_of(digest_of_row(found));
    read.reset();
    if (!intact) return damaged("the note \"" + name + "\"");
    return std::optional(std::move(found.value));
}

}  // namespace jostle::server
