// SPDX-License-Identifier: MIT
//
// A running world whose disk fails: it continues, rejects inputs that it cannot persist, and
// resumes persisting by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/recovery/recover_world.h"
#include "server/recovery/world_archive.h"
#include "server/storage/sqlite_storage.h"
#include "server/world/world_directory.h"
#include "tests/server/storage/failing_disk.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::DiskFault;

class StorageFailures : public testing::Test {
protected:
    void TearDown() override { test::set_disk_fault(DiskFault::none); }

    // Sends an impulse every 5 ms until `done` returns true or the timeout passes.
    template <class Done>
    bool play(WorldHost& world, Clock::duration timeout, Done&& done) {
        for (const auto end = Clock::now() + timeout; Clock::now() < end;) {
            world.mailbox().push({.client = 1,
                                  .sequence = ++sequence_,
                                  .action = ImpulseCommand{2, {0, 1, 0}, {}},
                                  .reply = results_,
                                  .received = Clock::now()});
            std::this_thread::sleep_for(5ms);
            for (const InputResult& result : results_->take()) {
                const bool not_persisted =
                    !result.status.ok() && result.status.error().code == ErrorCode::unavailable;
                (not_persisted ? refused_ : applied_).insert(result.sequence);
            }
            if (done()) return true;
        }
        return false;
    }

    std::uint32_t sequence_ = 0;
    std::shared_ptr<ResultQueue> results_ = std::make_shared<ResultQueue>();
    std::set<std::uint32_t> applied_, refused_;
};

class FailingStorage : public StorageFailures, public testing::WithParamInterface<DiskFault> {};

TEST_P(FailingStorage, world_continues_running_and_persistence_recovers) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    const HostLimits limits{.scene = {.bodies_max = 400}};
    {
        auto archive =
            WorldArchive::open({.database = path}, limits, 1, nullptr, test::failing_disk())
                .value();
        WorldDirectory worlds({.limits = limits, .world_persistence = archive.get()}, 4, "test");
        const auto world = worlds.create("yard", *scenes::find_scene("stack")).value();
        ASSERT_TRUE(play(*world, 20s, [&] { return applied_.size() > 20; }));
        EXPECT_TRUE(refused_.empty());

        test::set_disk_fault(GetParam());
        ASSERT_TRUE(play(*world, 20s, [&] { return refused_.size() > 50; }))
            << "inputs that cannot be persisted must be rejected";
        EXPECT_TRUE(archive->failure_reason().has_value());
        const std::uint32_t tick = world->frame()->tick;
        EXPECT_TRUE(play(*world, 10s, [&] { return world->frame()->tick > tick + 20; }))
            << "ticks must not wait for the disk";

        if (GetParam() != DiskFault::slow) test::set_disk_fault(DiskFault::none);
        const std::size_t previous = applied_.size();
        const auto repaired = Clock::now();
        EXPECT_TRUE(play(*world, 20s, [&] { return applied_.size() > previous + 20; }))
            << "persistence must recover by itself";
        // About 0.33 s on an idle machine.
        RecordProperty("ms_until_persisted_again",
                       static_cast<int>(to_ms(Clock::now() - repaired)));
        EXPECT_FALSE(archive->failure_reason().has_value());
        world->skip_final_checkpoint();  // like a killed process
        worlds.stop_all();
        ASSERT_TRUE(archive->flush(5s));
    }
    // Applied inputs are persisted; rejected inputs are not.
    for (const InputResult& result : results_->take()) applied_.insert(result.sequence);
    auto store = SqliteStorage::open(path, {}).value();
    const StoredWorld stored = store->worlds().value().at(0);
    const auto record = decode_world_definition(stored.settings).value();
    std::set<std::uint32_t> persisted;
    const auto collect = [&](const JournaledTick& tick) {
        for (const JournaledCommand& command : tick.commands) persisted.insert(command.sequence);
        return true;
    };
    const auto found = recover_world(*store, stored, record, {.may_apply = collect}).value();
    EXPECT_TRUE(found.warnings.empty());
    EXPECT_TRUE(std::ranges::includes(persisted, applied_));
    for (const std::uint32_t sequence : refused_) EXPECT_FALSE(persisted.contains(sequence));
}

// Killed, and the disk is full when the next process starts.
TEST_F(StorageFailures, starts_on_a_full_disk_and_persists_when_there_is_space) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    const HostLimits limits{.scene = {.bodies_max = 400}};
    std::uint32_t tick = 0;
    const auto open_archive = [&] {
        return WorldArchive::open({.database = path}, limits, 1, nullptr, test::failing_disk());
    };
    {
        auto archive = open_archive().value();
        WorldDirectory worlds({.limits = limits, .world_persistence = archive.get()}, 4, "test");
        const auto world = worlds.create("yard", *scenes::find_scene("stack")).value();
        ASSERT_TRUE(play(*world, 20s, [&] { return applied_.size() > 20; }));
        world->skip_final_checkpoint();
        worlds.stop_all();
        ASSERT_TRUE(archive->flush(5s));
        tick = world->frame()->tick;
    }
    test::set_disk_fault(DiskFault::full);
    auto archive = open_archive().value();
    WorldDirectory worlds({.limits = limits, .world_persistence = archive.get()}, 4, "test");
    std::vector<PersistedWorld> loaded = archive->take_worlds();
    ASSERT_EQ(loaded.size(), 1u);
    EXPECT_GE(loaded[0].start.tick + 1, tick);
    const auto world = worlds.adopt(std::move(loaded[0].start));
    ASSERT_TRUE(play(*world, 20s, [&] { return refused_.size() > 20; }));
    EXPECT_TRUE(archive->failure_reason().has_value());
    EXPECT_EQ(archive->failures(), 1u);
    const std::size_t previous = applied_.size();
    test::set_disk_fault(DiskFault::none);
    EXPECT_TRUE(play(*world, 20s, [&] { return applied_.size() > previous + 20; }));
    EXPECT_FALSE(archive->failure_reason().has_value());
    worlds.stop_all();
    EXPECT_TRUE(archive->flush(5s));
}

std::string name_of_fault(const testing::TestParamInfo<DiskFault>& fault) {
    static constexpr std::array<const char*, 5> names = {"none", "error", "full", "torn", "slow"};
    return names[static_cast<std::size_t>(fault.param)];
}
INSTANTIATE_TEST_SUITE_P(Faults, FailingStorage,
                         testing::Values(DiskFault::error, DiskFault::full, DiskFault::torn,
                                         DiskFault::slow),
                         name_of_fault);

}  // namespace
}  // namespace jostle::server
