// SPDX-License-Identifier: MIT
#include "server/storage/backup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "server/storage/online_backup.h"
#include "server/storage/sqlite_storage.h"
#include "tests/server/storage/journals.h"
#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using test::error_of;

// A database whose world "sea" grows.
class BackupTest : public testing::Test {
protected:
    BackupTest() {
        store = SqliteStorage::open(path, {.durability = Durability::process}).value();
        const StorageChange first[] = {PutWorld{test::stored_world("sea")},
                                       PutCheckpoint{"sea", {.tick = 0, .exact = "at first"}}};
        store->write(first).expect();
        append(100);
    }
    void append(int entries) {
        for (int k = 0; k < entries; k++) {
            const StorageChange change[] = {sea.next(std::string(5000, 'x'))};
            store->write(change).expect();
        }
    }
    // Writes an entry between any two steps of the backup.
    void back_up_while_writing() {
        auto backup = store->begin_backup(copy).value();
        while (!backup->step(10).value()) append(1);
        backup->finish().expect();
    }

    const test::TempFolder folder;
    const std::string path = folder / "worlds.db", copy = folder / "copy.db";
    std::unique_ptr<SqliteStorage> store;
    test::JournalMaker sea{"sea"};
};

TEST_F(BackupTest, contains_what_is_written_meanwhile) {
    back_up_while_writing();
    const StoreReport report = verify_store(copy).value();
    EXPECT_TRUE(report.errors.empty());
    EXPECT_TRUE(report.is_backup);
    ASSERT_EQ(report.worlds.size(), 1u);
    EXPECT_EQ(report.worlds[0].name, "The sea");
    EXPECT_EQ(report.worlds[0].checkpoints, 1u);
    const std::size_t entries = store->entries("sea", 0, 1 << 30)->size();
    EXPECT_GT(entries, 105u) << "entries were written during the backup";
    EXPECT_EQ(report.worlds[0].entries, entries);
    EXPECT_FALSE(std::filesystem::exists(copy + "-wal"));
}

TEST_F(BackupTest, restores_and_renames_the_files_so_far) {
    back_up_while_writing();
    const std::size_t entries = store->entries("sea", 0, 1 << 30)->size();
    append(5);
    EXPECT_EQ(error_of(restore_store(copy, path)).code, ErrorCode::failed_precondition)
        << "a server uses the database";
    store.reset();
    const auto renamed = restore_store(copy, path).value();
    EXPECT_EQ(renamed.size(), 2u) << "the database and its head";
    for (const std::string& name : renamed) EXPECT_TRUE(std::filesystem::exists(name)) << name;
    store = SqliteStorage::open(path, {}).value();
    EXPECT_TRUE(store->damage().is_none());
    EXPECT_EQ(store->entries("sea", 0, 1 << 30)->size(), entries);
    const StorageChange note[] = {PutNote{"a", "b"}};
    EXPECT_TRUE(store->write(note).ok());
    store.reset();
    EXPECT_TRUE(SqliteStorage::open(path, {}).value()->damage().is_none());
    EXPECT_FALSE(verify_store(path)->is_backup);
}

// An operator copies a backup over the database and leaves the head file.
TEST_F(BackupTest, a_backup_beside_a_newer_head_is_reported) {
    back_up_while_writing();
    append(5);
    store.reset();
    std::filesystem::copy_file(copy, path, std::filesystem::copy_options::overwrite_existing);
    EXPECT_NE(SqliteStorage::open(path, {}).value()->damage().store, "");
}

TEST_F(BackupTest, verification_names_a_changed_row) {
    back_up_while_writing();
    std::string bytes = folder.read("copy.db");
    const std::size_t at = bytes.find("at first");
    ASSERT_NE(at, std::string::npos);
    bytes[at] = 'A';
    const std::string changed = folder.write("changed.db", bytes);
    const StoreReport report = verify_store(changed).value();
    ASSERT_EQ(report.errors.size(), 1u);
    EXPECT_EQ(report.errors[0],
              "the checkpoint of tick 0 of world \"sea\" changed after it was written; the disk or "
              "the file is corrupt");
    store.reset();
    EXPECT_EQ(error_of(restore_store(changed, path)).code, ErrorCode::corrupt_data);
    EXPECT_TRUE(SqliteStorage::open(path, {}).value()->damage().is_none()) << "nothing changed";
}

TEST_F(BackupTest, rejects_what_is_no_finished_backup) {
    {
        const auto unfinished = store->begin_backup(copy).value();
        EXPECT_FALSE(unfinished->step(1).value());
    }
    EXPECT_FALSE(std::filesystem::exists(copy)) << "an unfinished backup is deleted";
    store.reset();
    EXPECT_EQ(error_of(restore_store(path, folder / "other.db")).message,
              path + " is a database of a server and not a backup; jostlectl backup makes one");
    EXPECT_EQ(error_of(verify_store(folder / "nothing.db")).code, ErrorCode::not_found);
    EXPECT_EQ(error_of(verify_store(folder.write("text.db", std::string(3000, 't')))).code,
              ErrorCode::corrupt_data);
}

}  // namespace
}  // namespace jostle::server
