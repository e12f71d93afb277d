// SPDX-License-Identifier: MIT
#include "server/storage/sqlite_storage.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "jostle/base/check.h"
#include "server/storage/journal_chain.h"
#include "server/storage/online_backup.h"
#include "server/storage/sqlite_database.h"
#include "server/storage/sqlite_schema.h"
#include "server/storage/store_head.h"

namespace jostle::server {
namespace {

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
std::string name_of_checkpoint(const std::string& world, std::uint32_t tick) {
    return "the checkpoint of tick " + std::to_string(tick) + " of world \"" + world + "\"";
}
std::string name_of(const std::string& world, const JournalEntry& e) {
    return "entry " + std::to_string(e.sequence) + " of the journal of world \"" + world + "\"";
}

// Of a row with the columns sequence, epoch, first_tick, last_tick, chain and data.
JournalEntry entry_of(const SqliteStatement& row) {
    JournalEntry e{.sequence = row.number(0),
                   .epoch = row.number(1),
                   .first_tick = static_cast<std::uint32_t>(row.number(2)),
                   .last_tick = static_cast<std::uint32_t>(row.number(3)),
                   .data = std::string(row.bytes(5))};
    if (row.bytes(4).size() == sizeof(Chain))
        std::copy_n(row.bytes(4).begin(), sizeof(Chain), e.chain.begin());
    return e;
}
// Of a row with the columns tick, hash, sequence, exact and portable.
Checkpoint checkpoint_of(const SqliteStatement& row) {
    return {.tick = static_cast<std::uint32_t>(row.number(0)),
            .hash = row.number(1),
            .sequence = row.number(2),
            .exact = std::string(row.bytes(3)),
            .portable = std::string(row.bytes(4))};
}

}  // namespace

// Prepared statements for repeated use.
class SqliteStorage::Database {
public:
    enum Kind {
        digest_of_world,
        put_world,
        drop_world,
        append,
        digest_of_entry,
        last_sequence,
        digest_of_checkpoint,
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
        put_head,
        put_world_head,
        drop_world_head,
        kinds,
    };

    explicit Database(SqliteDatabase database) : database_(std::move(database)) {}

    Status prepare() {
        static constexpr std::array<const char*, kinds> texts = {
            "SELECT digest FROM world WHERE id = ?1",
            "INSERT INTO world VALUES(?1, ?2, ?3, ?4, ?5, ?6) ON CONFLICT(id) DO UPDATE SET "
            "name = ?2, epoch = ?3, engine = ?4, settings = ?5, digest = ?6",
            "DELETE FROM world WHERE id = ?1",
            "INSERT INTO journal VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)",
            "SELECT digest FROM journal WHERE world = ?1 AND sequence = ?2",
            "SELECT max(sequence) FROM journal WHERE world = ?1",
            "SELECT digest FROM checkpoint WHERE world = ?1 AND tick = ?2",
            "INSERT OR REPLACE INTO checkpoint VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7)",
            "DELETE FROM checkpoint WHERE world = ?1 AND tick < ?2 RETURNING digest",
            "DELETE FROM journal WHERE world = ?1 AND sequence < "
            "(SELECT sequence FROM checkpoint WHERE world = ?1 AND tick = ?2) RETURNING digest",
            "SELECT id, name, epoch, engine, settings, digest FROM world ORDER BY id",
            "SELECT tick FROM checkpoint WHERE world = ?1 ORDER BY tick DESC",
            "SELECT tick, hash, sequence, exact, portable, digest FROM checkpoint "
            "WHERE world = ?1 AND tick = ?2",
            "SELECT sequence, epoch, first_tick, last_tick, chain, data, digest FROM journal "
            "WHERE world = ?1 AND sequence > ?2 ORDER BY sequence",
            "SELECT chain FROM journal WHERE world = ?1 AND sequence = ?2",
            "DELETE FROM checkpoint WHERE world = ?1 AND tick > ?2 RETURNING digest",
            "DELETE FROM journal WHERE world = ?1 AND sequence > ?2 RETURNING digest",
            "INSERT OR REPLACE INTO note VALUES(?1, ?2, ?3)",
            "SELECT value, digest FROM note WHERE name = ?1",
            "UPDATE head SET commits = ?1, written = ?2, is_backup = 0, total = ?3",
            "INSERT OR REPLACE INTO world_head VALUES(?1, ?2)",
            "DELETE FROM world_head WHERE world = ?1",
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
        if (Status s = remove(put.world.id, of(digest_of_world).bind(1, put.world.id)); !s.ok())
            return s;
        add(put.world.id, digest);
        return of(put_world)
            .bind(1, put.world.id)
            .bind(2, put.world.name)
            .bind(3, put.world.epoch)
            .bind(4, put.world.engine)
            .bind(5, put.world.settings)
            .bind(6, view_of(digest))
            .run();
    }
    Status operator()(const DropWorld& drop) {
        change(drop.id) = {};
        return of(drop_world).bind(1, drop.id).run();
    }
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
        add(world, digest);
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
        if (Status s = remove(
                world, of(digest_of_checkpoint).bind(1, world).bind(2, std::uint64_t{c.tick}));
            !s.ok())
            return s;
        add(world, digest);
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
            if (Status s = remove(trim.world,
                                  of(kind).bind(1, trim.world).bind(2, std::uint64_t{trim.tick}));
                !s.ok())
                return s;
        return {};
    }
    Status operator()(const TruncateJournal& truncate) {
        const auto& [world, tick, sequence] = truncate;
        Status done =
            remove(world, of(truncate_checkpoints).bind(1, world).bind(2, std::uint64_t{tick}));
        return done.ok() ? remove(world, of(truncate_journal).bind(1, world).bind(2, sequence))
                         : done;
    }
    Status operator()(const PutNote& note) {
        const Digest digest = digest_of_row(note);
        SqliteStatement& known = of(read_note).bind(1, note.name);
        const Result<bool> row = known.step();
        if (!row.ok()) return row.error();
        if (*row) changed_total_.add(known.bytes(1));
        known.reset();
        changed_total_.add(view_of(digest));
        return of(put_note).bind(1, note.name).bind(2, note.value).bind(3, view_of(digest)).run();
    }

    // ---- the head ----

    const StoreHead& head() const { return head_.store; }
    bool is_backup() const { return head_.is_backup; }
    void set_head(DatabaseHead head) { head_ = std::move(head); }

    // Call before the first change of a transaction.
    void begin_totals() {
        changed_.clear();
        changed_total_ = head_.store.total;
    }
    // Writes the totals of the changes as the head of the next commit.
    Status write_head() {
        for (const auto& [world, total] : changed_) {
            const bool is_dropped = total == DigestTotal();
            SqliteStatement& put = of(is_dropped ? drop_world_head : put_world_head).bind(1, world);
            if (Status s = is_dropped ? put.run() : put.bind(2, view_of(total.value())).run();
                !s.ok())
                return s;
        }
        return of(put_head)
            .bind(1, head_.store.commits + 1)
            .bind(2, now())
            .bind(3, view_of(changed_total_.value()))
            .run();
    }
    // Writes the head that was set as that of the next commit.
    Status rewrite_heads() {
        begin_totals();
        changed_ = head_.worlds;
        return write_head();
    }
    // After the commit.
    void keep_totals() {
        for (const auto& [world, total] : changed_)
            if (total == DigestTotal())
                head_.worlds.erase(world);
            else
                head_.worlds[world] = total;
        head_.store.total = changed_total_;
        head_.store.commits++;
        head_.is_backup = false;
        head_.store.written = now();
    }

private:
    static std::uint64_t now() { return static_cast<std::uint64_t>(std::time(nullptr)); }

    // The total of a world after the changes so far; assigning to it also changes the total of all.
    class Change {
    public:
        Change(DigestTotal& world, DigestTotal& all) : world_(world), all_(all) {}
        void add(std::string_view digest) {
            world_.add(digest);
            all_.add(digest);
        }
        void operator=(const DigestTotal& total) {
            all_.add(view_of(world_.value()));
            all_.add(view_of(total.value()));
            world_ = total;
        }

    private:
        DigestTotal &world_, &all_;
    };
    Change change(const std::string& world) {
        const auto known = head_.worlds.find(world);
        const auto at =
            changed_.try_emplace(world, known != head_.worlds.end() ? known->second : DigestTotal())
                .first;
        return {at->second, changed_total_};
    }
    void add(const std::string& world, const Digest& digest) { change(world).add(view_of(digest)); }
    // Runs a statement that returns the digests of the rows that it deletes or is about to replace.
    Status remove(const std::string& world, SqliteStatement& statement) {
        for (;;) {
            const Result<bool> row = statement.step();
            if (!row.ok()) return row.error();
            if (!*row) return {};
            change(world).add(statement.bytes(0));
        }
    }

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
    DatabaseHead head_;
    // Of the open transaction.
    std::map<std::string, DigestTotal> changed_;
    DigestTotal changed_total_;
};

SqliteStorage::SqliteStorage(std::string path, std::unique_ptr<Database> database,
                             std::unique_ptr<HeadFile> head_file)
    : path_(std::move(path)), database_(std::move(database)), head_file_(std::move(head_file)) {}
SqliteStorage::~SqliteStorage() = default;

namespace {

constexpr const char* head_suffix = ".head";

std::optional<SqliteStorage::FileId> file_id(const std::string& path) {
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0) return std::nullopt;
    return SqliteStorage::FileId{about.st_dev, about.st_ino};
}

Error named(const std::string& path, Error error) {
    error.message = path + ": " + error.message;
    return error;
}

}  // namespace

Result<std::unique_ptr<SqliteStorage>> SqliteStorage::open(const std::string& path,
                                                           const SqliteStorageOptions& options) {
    const bool is_durable = options.durability == Durability::machine;
    auto head = std::make_unique<HeadFile>(path + head_suffix, is_durable);
    const Result<HeadFile::Content> content = head->read();
    if (!content.ok()) return content.error();
    if (options.create && content->head && content->head->commits > 1 &&
        ::access(path.c_str(), F_OK) != 0)
        return named(path,
                     {ErrorCode::corrupt_data,
                      "it is missing, but " + head->path() + " says that it was in use until " +
                          utc_text(content->head->written) +
                          "; restore a backup, or delete that file to start without it"});
    Result<SqliteDatabase> opened =
        SqliteDatabase::open(path, options.file_system, options.create, options.is_read_only);
    if (!opened.ok()) return named(path, opened.error());
    // The log of a damaged database may contain what is missing.
    opened->empty_log_on_close(false);
    const OpenMode mode = options.is_read_only ? OpenMode::only_reading
                          : is_durable         ? OpenMode::durable
                                               : OpenMode::fast;
    if (Status s = open_schema(*opened, mode, *head, *content); !s.ok())
        return named(path, s.error());
    auto database = std::make_unique<Database>(*std::move(opened));
    if (Status s = database->prepare(); !s.ok()) return named(path, s.error());
    std::unique_ptr<SqliteStorage> storage(
        new SqliteStorage(path, std::move(database), std::move(head)));
    if (Status s = storage->find_damage(); !s.ok()) return named(path, s.error());
    (*storage->database_)->empty_log_on_close(storage->damage_.is_none());
    return storage;
}

// Compares the rows with the head of the database, and that with the head file.
Status SqliteStorage::find_damage() {
    Database& database = *database_;
    Result<DatabaseHead> head = read_head(*database);
    if (!head.ok()) return head.error();
    const Result<RowTotals> rows = sum_rows(*database);
    if (!rows.ok()) return rows.error();
    const Result<HeadFile::Content> content = head_file_->read();
    if (!content.ok()) return content.error();
    damage_.store = head_conflict(head->store, head->is_backup, *content, head_file_->path());
    RowTotals expected{.worlds = head->worlds, .notes = rows->notes};
    if (damage_.store.empty() && expected.of_all() != head->store.total)
        damage_.store = "its list of worlds or its notes are not those of the last commit";
    for (const auto& [world, total] : head->worlds)
        if (const auto at = rows->worlds.find(world);
            at == rows->worlds.end() || at->second != total)
            damage_.worlds[world] = "rows of it are missing or are not those of the last commit";
    for (const auto& [world, total] : rows->worlds)
        if (!head->worlds.contains(world))
            damage_.worlds[world] = "it is not in the list of worlds of the last commit";
    database.set_head(*std::move(head));
    files_.clear();
    for (const std::string& path : {path_, path_ + "-wal", head_file_->path()})
        if (const std::optional<FileId> id = file_id(path)) files_.emplace_back(path, *id);
    return {};
}

Status SqliteStorage::check_rows(std::vector<std::string>& errors) {
    Database& database = *database_;
    const auto read = [&](const char* query, const auto& name_if_damaged) -> Status {
        Result<SqliteStatement> rows = database->prepare(query);
        if (!rows.ok()) return rows.error();
        for (;;) {
            const Result<bool> row = rows->step();
            if (!row.ok()) return row.error();
            if (!*row) return {};
            if (const std::string name = name_if_damaged(*rows); !name.empty())
                errors.push_back(damaged(name).message);
        }
    };
    Status done = read(
        "SELECT sequence, epoch, first_tick, last_tick, chain, data, digest, world FROM journal",
        [](const SqliteStatement& row) -> std::string {
            const std::string world(row.bytes(7));
            const JournalEntry entry = entry_of(row);
            return row.bytes(6) == view_of(digest_of_row(world, entry)) ? ""
                                                                        : name_of(world, entry);
        });
    if (!done.ok()) return done;
    done = read("SELECT tick, hash, sequence, exact, portable, digest, world FROM checkpoint",
                [](const SqliteStatement& row) -> std::string {
                    const std::string world(row.bytes(6));
                    const Checkpoint found = checkpoint_of(row);
                    const bool is_intact = row.bytes(5) == view_of(digest_of_row(world, found));
                    return is_intact ? "" : name_of_checkpoint(world, found.tick);
                });
    if (!done.ok()) return done;
    return read("SELECT name, value, digest FROM note", [](const SqliteStatement& row) {
        const PutNote note{std::string(row.bytes(0)), std::string(row.bytes(1))};
        const bool is_intact = row.bytes(2) == view_of(digest_of_row(note));
        return is_intact ? std::string() : "the note \"" + note.name + "\"";
    });
}

StoreSummary SqliteStorage::summary() {
    const StoreHead& head = database_->head();
    return {.commits = head.commits,
            .written = head.written,
            .bytes = bytes_on_disk(),
            .is_backup = database_->is_backup()};
}

Result<std::unique_ptr<OnlineBackup>> SqliteStorage::begin_backup(const std::string& path) {
    if (!damage_.is_none())
        return Error{ErrorCode::failed_precondition,
                     "the database is damaged, and so would be the backup; copy its files instead"};
    return OnlineBackup::begin(**database_, path);
}

Status SqliteStorage::accept_damage() {
    Database& database = *database_;
    const Result<RowTotals> rows = sum_rows(*database);
    if (!rows.ok()) return rows.error();
    const Result<HeadFile::Content> content = head_file_->read();
    if (!content.ok()) return content.error();
    DatabaseHead head{.store = database.head(), .worlds = rows->worlds};
    if (content->head && content->head->commits > head.store.commits)
        head.store.commits = content->head->commits;
    head.store.total = rows->of_all();
    Status done = database->execute("BEGIN IMMEDIATE; DELETE FROM world_head");
    if (done.ok()) {
        database.set_head(std::move(head));
        done = database.rewrite_heads();
    }
    if (done.ok()) done = database->execute("COMMIT");
    if (!done.ok()) {
        if (database->in_transaction()) static_cast<void>(database->execute("ROLLBACK").ok());
        return done;
    }
    database.keep_totals();
    database->empty_log_on_close(true);
    damage_ = {};
    return head_file_->write(database.head());
}

Status SqliteStorage::check_files() {
    for (const auto& [path, id] : files_)
        if (const std::optional<FileId> now = file_id(path); now != id)
            return Error{ErrorCode::unavailable,
                         path + (now ? " was replaced" : " was removed or cannot be read") +
                             " while the server uses it; what is written now would be lost"};
    return {};
}

std::uint64_t SqliteStorage::bytes_on_disk() {
    std::uint64_t bytes = 0;
    for (const auto& [path, id] : files_) {
        struct stat about {};
        if (::stat(path.c_str(), &about) == 0) bytes += static_cast<std::uint64_t>(about.st_size);
    }
    return bytes;
}

Status SqliteStorage::write(std::span<const StorageChange> changes) {
    Database& database = *database_;
    if (!damage_.store.empty()) return Error{ErrorCode::failed_precondition, damage_.store};
    if (Status s = check_files(); !s.ok()) return s;
    Status done = database->execute("BEGIN IMMEDIATE");
    database.begin_totals();
    for (const StorageChange& change : changes)
        if (done.ok()) done = std::visit(database, change);
    if (done.ok()) done = database.write_head();
    if (done.ok()) done = database->execute("COMMIT");
    // Some errors have already ended the transaction.
    if (!done.ok() && database->in_transaction()) {
        const Status undone = database->execute("ROLLBACK");
        if (!undone.ok()) return undone;
    }
    if (!done.ok()) return done;
    database.keep_totals();
    // The changes count as written only if their loss would be noticed. The same changes can be
    // written again.
    if (Status s = head_file_->write(database.head()); !s.ok()) return s;
    // A short log loses little if it is damaged. A log that cannot be emptied now is emptied later.
    const auto is_checkpoint = [](const StorageChange& change) {
        return std::holds_alternative<PutCheckpoint>(change);
    };
    if (std::ranges::any_of(changes, is_checkpoint)) database->empty_log();
    return {};
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
    const std::string where = name_of_checkpoint(world, tick);
    SqliteStatement& read =
        database_->of(Database::read_checkpoint).bind(1, world).bind(2, std::uint64_t{tick});
    const Result<bool> row = read.step();
    if (!row.ok()) return row.error();
    if (!*row) return Error{ErrorCode::not_found, where + " does not exist"};
    Checkpoint found = checkpoint_of(read);
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
        JournalEntry e = entry_of(list);
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
