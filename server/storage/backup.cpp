// SPDX-License-Identifier: MIT
#include "server/storage/backup.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

#include "server/storage/online_backup.h"
#include "server/storage/sqlite_storage.h"

namespace jostle::server {
namespace {

namespace fs = std::filesystem;

// The files of a database, by the suffixes of their names.
constexpr const char* suffixes[] = {"", "-wal", "-shm", ".head", ".marks"};

// Fails if another process has the database open. Changes no file, so that a damaged or older
// database is renamed as it is.
Status check_unused(const std::string& path) {
    if (!fs::exists(path)) return {};
    Result<SqliteDatabase> database = SqliteDatabase::open(path, nullptr, false);
    if (!database.ok()) return {};  // whatever it is, it is renamed
    database->empty_log_on_close(!fs::exists(path + "-wal"));
    const Status locked = database->execute("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE");
    if (locked.ok()) return database->execute("ROLLBACK");
    if (locked.error().code != ErrorCode::unavailable) return {};
    return Error{ErrorCode::failed_precondition, path + ": another process has it open (" +
                                                     locked.error().message +
                                                     "); stop the server first"};
}

}  // namespace

Result<StoreReport> verify_store(const std::string& path) {
    Result<std::unique_ptr<SqliteStorage>> storage =
        SqliteStorage::open(path, {.create = false, .is_read_only = true});
    if (!storage.ok()) return storage.error();
    StoreReport report{(*storage)->summary(), {}, {}};
    if (!(*storage)->damage().store.empty()) report.errors.push_back((*storage)->damage().store);
    for (const auto& [world, damage] : (*storage)->damage().worlds)
        report.errors.push_back("world " + world + ": " + damage);
    if (Status s = (*storage)->check_rows(report.errors); !s.ok()) return s.error();
    const auto worlds = (*storage)->worlds();
    if (!worlds.ok()) {
        report.errors.push_back(worlds.error().message);
        return report;
    }
    for (const StoredWorld& stored : *worlds) {
        StoreReport::World world{.id = stored.id, .name = stored.name};
        const auto ticks = (*storage)->checkpoint_ticks(stored.id);
        if (!ticks.ok()) return ticks.error();
        world.checkpoints = ticks->size();
        if (!ticks->empty()) world.last_tick = ticks->front();
        if (ticks->empty()) report.errors.push_back("world " + stored.id + " has no checkpoint");
        // Reads the journal as a recovery from the oldest checkpoint would.
        std::uint64_t after = 0;
        if (!ticks->empty())
            if (const auto oldest = (*storage)->checkpoint(stored.id, ticks->back()); oldest.ok())
                after = oldest->sequence;
        for (;;) {
            const auto entries = (*storage)->entries(stored.id, after, 8 << 20);
            if (!entries.ok()) report.errors.push_back(entries.error().message);
            if (!entries.ok() || entries->empty()) break;
            world.entries += entries->size();
            world.last_tick = std::max(world.last_tick, entries->back().last_tick);
            after = entries->back().sequence;
        }
        report.worlds.push_back(std::move(world));
    }
    return report;
}

Result<std::vector<std::string>> restore_store(const std::string& backup, const std::string& path) {
    const Result<StoreReport> report = verify_store(backup);
    if (!report.ok()) return report.error();
    if (!report->errors.empty())
        return Error{ErrorCode::corrupt_data, backup + " is damaged: " + report->errors.front()};
    if (!report->is_backup)
        return Error{ErrorCode::corrupt_data,
                     backup +
                         " is a database of a server and not a backup; jostlectl backup makes "
                         "one"};
    if (Status s = check_unused(path); !s.ok()) return s.error();
    const std::string copy = path + ".restoring";
    std::error_code error;
    fs::copy_file(backup, copy, fs::copy_options::overwrite_existing, error);
    if (error) return Error{ErrorCode::unavailable, copy + ": " + error.message()};
    fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
    if (Status s = sync_path(copy); !s.ok()) {
        ::unlink(copy.c_str());
        return s.error();
    }
    const std::string aside = path + ".before-restore-" + std::to_string(std::time(nullptr));
    std::vector<std::string> renamed;
    const auto undo = [&] {
        for (const std::string& name : renamed)
            fs::rename(name, path + name.substr(aside.size()), error);
        ::unlink(copy.c_str());
    };
    for (const char* suffix : suffixes) {
        if (!fs::exists(path + suffix)) continue;
        fs::rename(path + suffix, aside + suffix, error);
        if (error) {
            const Error failed{ErrorCode::unavailable, path + suffix + ": " + error.message()};
            undo();
            return failed;
        }
        renamed.push_back(aside + suffix);
    }
    fs::rename(copy, path, error);
    if (error) {
        const Error failed{ErrorCode::unavailable, path + ": " + error.message()};
        undo();
        return failed;
    }
    if (Status s = sync_path(folder_of(path)); !s.ok()) return s.error();
    return renamed;
}

}  // namespace jostle::server
