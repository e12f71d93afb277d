// SPDX-License-Identifier: MIT
#include "server/storage/sqlite_storage.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "server/storage/journal_chain.h"
#include "tests/server/storage/damaged_disk.h"
#include "tests/server/storage/failing_disk.h"
#include "tests/server/storage/journals.h"
#include "tests/support/error_of.h"
#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using test::error_of;
using test::JournalMaker;
using test::stored_world;

std::unique_ptr<SqliteStorage> opened(const std::string& path,
                                      const SqliteStorageOptions& options = {}) {
    Result<std::unique_ptr<SqliteStorage>> store = SqliteStorage::open(path, options);
    EXPECT_TRUE(store.ok()) << store.error().message;
    return store.ok() ? *std::move(store) : nullptr;
}
Status write(WorldStorage& store, std::vector<StorageChange> changes) {
    return store.write(changes);
}

// A world, twelve entries and two checkpoints.
std::vector<StorageChange> small_history(JournalMaker& journal, const std::string& id) {
    std::vector<StorageChange> all{PutWorld{stored_world(id)}};
    for (int k = 0; k < 12; k++)
        all.push_back(journal.next(id + " was pushed " + std::to_string(k)));
    all.push_back(
        PutCheckpoint{id, {60, 0xfedcba9876543210, 6, std::string(500, 'e'), "portable"}});
    all.push_back(PutCheckpoint{id, {100, 7, 10, std::string(700, 'f'), ""}});
    return all;
}

TEST(SqliteStorage, persists_across_restart) {
    const test::TempFolder folder;
    JournalMaker journal("sea");
    const std::vector<StorageChange> all = small_history(journal, "sea");
    ASSERT_TRUE(write(*opened(folder / "worlds.db"), all).ok());

    const auto store = opened(folder / "worlds.db");
    EXPECT_EQ(*store->worlds(), std::vector{stored_world("sea")});
    EXPECT_EQ(*store->checkpoint_ticks("sea"), (std::vector<std::uint32_t>{100, 60}));
    EXPECT_EQ(*store->checkpoint("sea", 60), std::get<PutCheckpoint>(all[13]).checkpoint);
    const auto entries = store->entries("sea", 6, 1 << 20);
    ASSERT_EQ(entries->size(), 6u);
    EXPECT_EQ(entries->front(), std::get<AppendEntry>(all[7]).entry);
    EXPECT_EQ(error_of(store->checkpoint("sea", 61)).code, ErrorCode::not_found);
    EXPECT_EQ(std::filesystem::status(folder / "worlds.db").permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST(SqliteStorage, pages_long_journals) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    JournalMaker journal("sea");
    std::vector<StorageChange> all{PutWorld{stored_world("sea")}};
    for (int k = 0; k < 100; k++) all.push_back(journal.next(std::string(100, 'x')));
    ASSERT_TRUE(store->write(all).ok());
    std::uint64_t after = 0;
    int pages = 0;
    for (;; pages++) {
        const auto page = store->entries("sea", after, 1000);
        ASSERT_TRUE(page.ok()) << page.error().message;
        if (page->empty()) break;
        EXPECT_LE(page->size(), 10u);
        after = page->back().sequence;
    }
    EXPECT_EQ(after, 100u);
    EXPECT_EQ(pages, 10);
}

TEST(SqliteStorage, writes_are_atomic) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    JournalMaker journal("sea"), nowhere("nowhere");
    const Error error = error_of(
        write(*store, {PutWorld{stored_world("sea")}, journal.next("a"), nowhere.next("b")}));
    EXPECT_EQ(error.code, ErrorCode::not_found) << error.message;
    EXPECT_TRUE(store->worlds()->empty());
}

TEST(SqliteStorage, repeated_writes_are_idempotent_and_conflicts_fail) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    JournalMaker journal("sea");
    const std::vector<StorageChange> all = small_history(journal, "sea");
    ASSERT_TRUE(store->write(all).ok());
    EXPECT_TRUE(store->write(all).ok());
    AppendEntry other = std::get<AppendEntry>(all[5]);
    other.entry.data += "?";
    EXPECT_EQ(error_of(write(*store, {other})).code, ErrorCode::already_exists);
    journal.next("lost");
    EXPECT_EQ(error_of(write(*store, {journal.next("too early")})).message,
              "entry 14 of the journal of world \"sea\" does not follow entry 12");
}

TEST(SqliteStorage, trimming_removes_old_entries_and_preserves_the_chain) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    JournalMaker journal("sea");
    ASSERT_TRUE(store->write(small_history(journal, "sea")).ok());
    ASSERT_TRUE(write(*store, {Trim{"sea", 100}}).ok());
    EXPECT_EQ(*store->checkpoint_ticks("sea"), std::vector<std::uint32_t>{100});
    EXPECT_EQ(store->entries("sea", 10, 1 << 20)->size(), 2u);
    EXPECT_EQ(error_of(store->entries("sea", 5, 1 << 20)).message,
              "entry 10 of the journal of world \"sea\": the preceding entry 6 is missing");
    ASSERT_TRUE(write(*store, {journal.next("after")}).ok());
    ASSERT_TRUE(write(*store, {DropWorld{"sea"}}).ok());
    EXPECT_TRUE(store->worlds()->empty());
    EXPECT_TRUE(store->checkpoint_ticks("sea")->empty());
}

TEST(SqliteStorage, rejects_a_second_process) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    ASSERT_TRUE(write(*store, {PutWorld{stored_world("sea")}}).ok());
    const pid_t child = fork();
    if (child == 0)  // another process, because locks belong to a process
        _exit(error_of(SqliteStorage::open(folder / "worlds.db", {})).code ==
                      ErrorCode::failed_precondition
                  ? 0
                  : 1);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

TEST(SqliteStorage, rejects_foreign_files_by_name) {
    const test::TempFolder folder;
    const std::string path = folder.write("notes.txt", std::string(2000, 'n'));
    EXPECT_EQ(error_of(SqliteStorage::open(path, {})).code, ErrorCode::corrupt_data);
    EXPECT_EQ(error_of(SqliteStorage::open(path, {})).message, path + ": file is not a database");
    EXPECT_EQ(error_of(SqliteStorage::open(folder / "no/such/folder.db", {})).code,
              ErrorCode::unavailable);
    EXPECT_EQ(folder.read("notes.txt"), std::string(2000, 'n')) << "the file must not be modified";
    const std::string few = folder.write("few.txt", "to do");
    EXPECT_EQ(error_of(SqliteStorage::open(few, {})).message, few + ": file is not a database");
    EXPECT_EQ(folder.read("few.txt"), "to do")
        << "a file that SQLite treats as empty must not be modified";

    sqlite3* other = nullptr;
    sqlite3_open((folder / "other.db").c_str(), &other);
    sqlite3_exec(other, "CREATE TABLE poems(text)", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    EXPECT_EQ(error_of(SqliteStorage::open(folder / "other.db", {})).message,
              folder / "other.db: it is an SQLite database, but not a Jostle database");

    opened(folder / "later.db");
    sqlite3_open((folder / "later.db").c_str(), &other);
    sqlite3_exec(other, "PRAGMA user_version = 9", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    EXPECT_EQ(error_of(SqliteStorage::open(folder / "later.db", {})).message,
              folder /
                  "later.db: it was written by a later version of Jostle (schema 9; this version "
                  "supports 3)");
}

TEST(SqliteStorage, migrates_the_previous_schema_version) {
    const test::TempFolder folder;
    const std::string path = folder / "old.db";
    const StorageChange world[] = {PutWorld{{.id = "w1", .name = "yard", .epoch = 3}}};
    EXPECT_TRUE(opened(path)->write(world).ok());
    sqlite3* old = nullptr;
    sqlite3_open(path.c_str(), &old);
    sqlite3_exec(old,
                 "DROP TABLE note; DROP TABLE head; DROP TABLE world_head; PRAGMA user_version = 1",
                 nullptr, nullptr, nullptr);
    sqlite3_close(old);
    EXPECT_EQ(error_of(SqliteStorage::open(path, {})).code, ErrorCode::corrupt_data)
        << "a database of the present version became one of the past";
    std::filesystem::remove(path + ".head");

    const StorageChange note[] = {PutNote{"secret", std::string("a\0b", 3)}};
    {
        const auto store = opened(path);
        EXPECT_TRUE(store->damage().is_none());
        EXPECT_EQ(store->worlds().value().at(0).name, "yard");
        EXPECT_EQ(store->note("secret").value(), std::nullopt);
        EXPECT_TRUE(store->write(note).ok());
    }
    EXPECT_TRUE(opened(path)->damage().is_none());
    EXPECT_EQ(opened(path)->note("secret").value(), std::string("a\0b", 3));
}

TEST(SqliteStorage, truncated_journal_accepts_new_entries) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db");
    Chain chain{};
    const auto entry = [&](std::uint64_t sequence, const std::string& data) {
        const auto tick = static_cast<std::uint32_t>(sequence);
        chain = next_chain(chain, data);
        return AppendEntry{"w1", {sequence, 1, tick, tick, chain, data}};
    };
    std::vector<StorageChange> changes{PutWorld{{.id = "w1"}}, entry(1, "a")};
    const Chain after_one = chain;
    changes.insert(changes.end(), {entry(2, "b"), entry(3, "c"), PutCheckpoint{"w1", {.tick = 1}},
                                   PutCheckpoint{"w1", {.tick = 3}}});
    EXPECT_TRUE(store->write(changes).ok());
    chain = after_one;
    const StorageChange other[] = {TruncateJournal{"w1", 2, 1}, entry(2, "B")};
    EXPECT_TRUE(store->write(other).ok());
    EXPECT_EQ(store->checkpoint_ticks("w1").value(), std::vector<std::uint32_t>{1});
    const auto entries = store->entries("w1", 0, 100).value();
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[1].data, "B");
}

// ---- damage ----

const char* const file_names[] = {"worlds.db", "worlds.db-wal", "worlds.db.head"};

test::FileContents files_of(const test::TempFolder& folder) {
    test::FileContents files;
    for (const char* name : file_names) files[name] = folder.read(name);
    return files;
}
void write_files(const test::TempFolder& folder, const test::FileContents& files) {
    for (const char* name : file_names) std::filesystem::remove(folder / name);
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
}

// The files of a process that was killed after commits of two worlds, and the files some commits
// before. A part of the last commits is in the log only.
struct KilledProcess {
    test::FileContents files, older;
};
KilledProcess killed_process() {
    const test::TempFolder folder;
    KilledProcess killed;
    const auto store = opened(folder / "worlds.db", {.durability = Durability::process});
    JournalMaker sea("sea"), hill("hill");
    EXPECT_TRUE(store->write(small_history(sea, "sea")).ok());
    EXPECT_TRUE(store->write(small_history(hill, "hill")).ok());
    for (int k = 0; k < 40; k++) {
        if (k == 25) killed.older = files_of(folder);
        std::vector<StorageChange> changes{
            sea.next("sea " + std::to_string(k) + std::string(300, 's')),
            hill.next("hill " + std::to_string(k)), PutNote{"clients", std::to_string(k)}};
        if (k % 15 == 12) {
            const auto tick = static_cast<std::uint32_t>(130 + 10 * k);
            const auto sequence = static_cast<std::uint64_t>(13 + k);
            changes.push_back(
                PutCheckpoint{"sea", {tick, 5, sequence, std::string(6000, 'c'), ""}});
            changes.push_back(Trim{"sea", tick});
        }
        EXPECT_TRUE(store->write(changes).ok());
    }
    killed.files = files_of(folder);  // as SIGKILL leaves them
    EXPECT_GT(killed.files["worlds.db-wal"].size(), 10'000u);
    return killed;
}

// Everything that can be read, as text; an error if anything is reported.
Result<std::string> content_of(const std::string& path) {
    const auto opened_store = SqliteStorage::open(path, {.durability = Durability::process});
    if (!opened_store.ok()) return opened_store.error();
    SqliteStorage& store = **opened_store;
    if (!store.damage().is_none()) return Error{ErrorCode::corrupt_data, "damage"};
    std::string text;
    const auto worlds = store.worlds();
    if (!worlds.ok()) return worlds.error();
    for (const StoredWorld& world : *worlds) {
        text += world.id + world.name + std::to_string(world.epoch) + world.settings;
        const auto ticks = store.checkpoint_ticks(world.id);
        if (!ticks.ok()) return ticks.error();
        for (const std::uint32_t tick : *ticks) {
            const auto checkpoint = store.checkpoint(world.id, tick);
            if (!checkpoint.ok()) return checkpoint.error();
            text += std::to_string(tick) + std::to_string(checkpoint->hash) + checkpoint->exact;
        }
        const auto oldest = store.checkpoint(world.id, ticks->back());
        const auto entries = store.entries(world.id, oldest->sequence - 1, 1 << 24);
        if (!entries.ok()) return entries.error();
        for (const JournalEntry& entry : *entries)
            text += std::to_string(entry.sequence) + entry.data;
    }
    const auto note = store.note("clients");
    if (!note.ok()) return note.error();
    return text + note->value_or("none");
}

TEST(SqliteStorage, continues_after_a_kill_without_damage) {
    const test::TempFolder folder;
    const KilledProcess killed = killed_process();
    write_files(folder, killed.files);
    EXPECT_TRUE(opened(folder / "worlds.db")->damage().is_none());
    EXPECT_TRUE(opened(folder / "worlds.db")->damage().is_none()) << "when it is opened again";
    // The process was killed between its last commit and the write of the head file.
    test::FileContents earlier = killed.files;
    earlier["worlds.db.head"] = killed.older.at("worlds.db.head");
    write_files(folder, earlier);
    EXPECT_TRUE(opened(folder / "worlds.db")->damage().is_none());
}

TEST(SqliteStorage, reports_commits_that_are_missing) {
    const test::TempFolder folder;
    const KilledProcess killed = killed_process();
    test::FileContents cut = killed.files;
    std::string& log = cut["worlds.db-wal"];
    log[log.size() - 3000] = static_cast<char>(log[log.size() - 3000] ^ 1);
    write_files(folder, cut);
    auto store = opened(folder / "worlds.db");
    EXPECT_TRUE(store->damage().store.find("commits are missing") != std::string::npos)
        << store->damage().store;
    JournalMaker other("other");
    EXPECT_EQ(error_of(write(*store, {PutWorld{stored_world("other")}})).code,
              ErrorCode::failed_precondition);
    EXPECT_EQ(store->worlds()->size(), 2u) << "the rest can be read";
    EXPECT_TRUE(folder.read("worlds.db-wal") == cut.at("worlds.db-wal"));

    store.reset();
    EXPECT_TRUE(folder.read("worlds.db-wal") == cut.at("worlds.db-wal"))
        << "closing a damaged database must not delete its log";

    cut["worlds.db-wal"] = "";
    write_files(folder, cut);
    EXPECT_FALSE(opened(folder / "worlds.db")->damage().store.empty()) << "without its log";
}

TEST(SqliteStorage, damage_can_be_accepted) {
    const test::TempFolder folder;
    test::FileContents cut = killed_process().files;
    cut["worlds.db-wal"].resize(cut["worlds.db-wal"].size() - 5000);
    write_files(folder, cut);
    {
        const auto store = opened(folder / "worlds.db");
        ASSERT_FALSE(store->damage().is_none());
        ASSERT_TRUE(store->accept_damage().ok());
        EXPECT_TRUE(store->damage().is_none());
        EXPECT_TRUE(write(*store, {PutNote{"clients", "more"}}).ok());
    }
    EXPECT_TRUE(opened(folder / "worlds.db")->damage().is_none());
    EXPECT_EQ(opened(folder / "worlds.db")->note("clients").value(), "more");
}

TEST(SqliteStorage, reports_incomplete_copies) {
    const test::TempFolder folder;
    const KilledProcess killed = killed_process();
    test::FileContents copy = killed.files;
    copy.erase("worlds.db.head");
    write_files(folder, copy);
    EXPECT_TRUE(opened(folder / "worlds.db")->damage().store.find("is missing") !=
                std::string::npos);
    copy = killed.files;
    copy.erase("worlds.db");
    write_files(folder, copy);
    const Error missing = error_of(SqliteStorage::open(folder / "worlds.db", {}));
    EXPECT_EQ(missing.code, ErrorCode::corrupt_data);
    EXPECT_NE(missing.message.find("it is missing, but"), std::string::npos) << missing.message;
    EXPECT_FALSE(std::filesystem::exists(folder / "worlds.db")) << "nothing was created";
}

TEST(SqliteStorage, notices_files_that_are_removed_or_replaced_while_it_is_open) {
    for (const char* name : file_names) {
        const test::TempFolder folder;
        const auto store = opened(folder / "worlds.db");
        ASSERT_TRUE(write(*store, {PutWorld{stored_world("sea")}}).ok());
        ASSERT_TRUE(store->check_files().ok());
        std::filesystem::rename(folder / name, folder / "aside");
        EXPECT_EQ(error_of(store->check_files()).code, ErrorCode::unavailable);
        EXPECT_EQ(
            error_of(write(*store, {PutWorld{stored_world("hill")}})).message,
            folder / name +
                " was removed or cannot be read while the server uses it; what is written now "
                "would be lost");
        std::filesystem::copy_file(folder / "aside", folder / name);
        EXPECT_FALSE(store->check_files().ok()) << "another file of the same name";
        std::filesystem::rename(folder / "aside", folder / name);
        EXPECT_TRUE(store->check_files().ok());
        EXPECT_TRUE(write(*store, {PutWorld{stored_world("hill")}}).ok());
    }
}

TEST(SqliteStorage, damaged_files_are_reported_or_harmless) {
    const KilledProcess killed = killed_process();
    const test::TempFolder folder;
    write_files(folder, killed.files);
    const std::string whole = content_of(folder / "worlds.db").value();
    const int damages = test::damages_to_try(600);
    test::Random random(31);
    int reports = 0;
    for (int k = 0; k < damages; k++) {
        test::FileContents files = killed.files;
        const std::string what = test::damage_one_file(files, killed.older, random);
        write_files(folder, files);
        const Result<std::string> content = content_of(folder / "worlds.db");
        EXPECT_TRUE(!content.ok() || *content == whole) << what << " is silent";
        reports += content.ok() ? 0 : 1;
    }
    EXPECT_GT(reports, damages / 3);
    RecordProperty("reports", reports);
}

// A process that writes continuously and reports which entries are durable.
void write_without_end(const std::string& path, int to) {
    const auto store = opened(path, {.durability = Durability::process});
    JournalMaker journal("sea");
    if (!write(*store, {PutWorld{stored_world("sea")}}).ok()) _exit(1);
    for (std::uint64_t sequence = 1;; sequence++) {
        if (!write(*store, {journal.next(std::string(300, 'w'))}).ok()) _exit(1);
        if (::write(to, &sequence, sizeof sequence) != sizeof sequence) _exit(1);
    }
}

TEST(SqliteStorage, durable_writes_survive_thirty_killed_processes) {
    test::Random random(9);
    for (int kill_number = 0; kill_number < 30; kill_number++) {
        const test::TempFolder folder;
        int pipe_ends[2];
        ASSERT_EQ(pipe(pipe_ends), 0);
        const pid_t child = fork();
        if (child == 0) write_without_end(folder / "worlds.db", pipe_ends[1]);
        close(pipe_ends[1]);
        std::uint64_t durable = 0, next = 0;
        const std::uint64_t until = 1 + random.below(60);
        while (durable < until && read(pipe_ends[0], &next, sizeof next) == sizeof next)
            durable = next;
        kill(child, SIGKILL);
        while (read(pipe_ends[0], &next, sizeof next) == sizeof next) durable = next;
        close(pipe_ends[0]);
        waitpid(child, nullptr, 0);
        const auto entries = opened(folder / "worlds.db")->entries("sea", 0, 1 << 24);
        ASSERT_TRUE(entries.ok()) << entries.error().message;
        EXPECT_GE(entries->size(), durable);
        EXPECT_LE(entries->size(), durable + 1);
    }
}

TEST(SqliteStorage, recovers_after_disk_failures) {
    const test::TempFolder folder;
    const auto store = opened(folder / "worlds.db", {.file_system = test::failing_disk()});
    JournalMaker journal("sea");
    ASSERT_TRUE(write(*store, {PutWorld{stored_world("sea")}}).ok());
    for (const auto& [fault, code] :
         {std::pair{test::DiskFault::error, ErrorCode::unavailable},
          std::pair{test::DiskFault::full, ErrorCode::resource_exhausted},
          std::pair{test::DiskFault::torn, ErrorCode::unavailable}}) {
        const AppendEntry entry = journal.next(std::string(9000, 'd'));
        test::set_disk_fault(fault);
        EXPECT_EQ(error_of(write(*store, {entry})).code, code);
        test::set_disk_fault(test::DiskFault::none);
        EXPECT_TRUE(write(*store, {entry}).ok());
    }
    EXPECT_EQ(store->entries("sea", 0, 1 << 20)->size(), 3u);
}

}  // namespace
}  // namespace jostle::server
