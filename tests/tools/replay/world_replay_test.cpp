// SPDX-License-Identifier: MIT
#include "tools/replay/world_replay.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/bench_scenes.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "server/recovery/world_archive.h"
#include "server/storage/sqlite_storage.h"
#include "server/world/world_directory.h"
#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::replay {
namespace {

using namespace std::chrono_literals;
using test::error_of;

// Plays in a yard of boxes for 200 ticks and persists it in a database; every tenth tick throws a
// ball. With `late` tick 125 throws one more.
void play(const std::string& path, bool late) {
    server::PersistenceSettings settings{.database = path,
                                         .durability = "process",
                                         .replay_seconds_max = 0.003,
                                         .history_retention_hours = 1};
    const server::HostLimits limits{.scene = {.bodies_max = 400}};
    auto archive = server::WorldArchive::open(settings, limits, 1, nullptr).value();
    server::WorldDirectory worlds(
        {.limits = limits, .own_ticks = false, .world_persistence = archive.get()}, 4, "test");
    const auto world = worlds.create("yard", *scenes::find_scene("stack")).value();
    std::uint32_t sequence = 0;
    for (std::uint32_t tick = 2; tick <= 201; tick++) {
        const bool extra = late && tick == 125;
        if (tick % 10 == 0) sequence++;
        if (tick % 10 == 0 || extra) {
            server::SpawnCommand ball;
            ball.shape.geometry = physics::Sphere{0.3};
            ball.pose.position = {0.1 * tick / 200.0, 6, 0};
            world->mailbox().push({.client = extra ? 2U : 1U,
                                   .sequence = extra ? 1 : sequence,
                                   .action = ball,
                                   .reply = nullptr});
        }
        world->tick(server::Clock::now());
        ASSERT_TRUE(archive->flush(5s));
    }
    worlds.stop_all();
    ASSERT_TRUE(archive->flush(5s));
}

TEST(PersistedWorld, replays_a_persisted_world_bit_identically) {
    const test::TempFolder folder;
    play(folder / "worlds.db", false);
    auto world = PersistedWorld::open(folder / "worlds.db", "yard").value();
    const auto summary = world.summary().value();
    EXPECT_EQ(summary.commands, 20u);
    EXPECT_EQ(summary.last_tick, 201u);
    EXPECT_GT(summary.checkpoints.size(), 2u);
    EXPECT_EQ(summary.corruption, "");
    const auto verified = world.verify().value();
    EXPECT_EQ(verified.errors, std::vector<std::string>());
    EXPECT_EQ(verified.checkpoints + 1, static_cast<int>(summary.checkpoints.size()));
    EXPECT_EQ(verified.last_tick, 201u);
}

TEST(PersistedWorld, exports_any_tick_as_a_scene) {
    const test::TempFolder folder;
    play(folder / "worlds.db", false);
    auto world = PersistedWorld::open(folder / "worlds.db", "yard").value();
    std::uint64_t hash = 0;
    EXPECT_TRUE(world
                    .hashes(50,
                            [&](std::uint32_t tick, std::uint64_t of) {
                                if (tick == 150) hash = of;
                            })
                    .ok());
    EXPECT_EQ(physics::state_hash(world.at(150).value().world.world()), hash);
    const auto scene = world.scene_at(150).value().scene;
    EXPECT_EQ(scene.bodies.size(), scenes::find_scene("stack")->bodies.size() + 15);
    EXPECT_TRUE(scenes::read_scene_json(scenes::write_scene_json(scene)).ok());
    EXPECT_EQ(error_of(world.at(202)).message, "tick 202 is not available; the last tick is 201");
}

TEST(PersistedWorld, finds_the_first_tick_in_which_two_databases_differ) {
    const test::TempFolder folder;
    play(folder / "a.db", false);
    play(folder / "b.db", true);
    play(folder / "c.db", false);
    auto a = PersistedWorld::open(folder / "a.db", "yard").value();
    auto b = PersistedWorld::open(folder / "b.db", "yard").value();
    auto c = PersistedWorld::open(folder / "c.db", "yard").value();
    EXPECT_EQ(a.first_difference(c).value().has_value(), false);
    const auto difference = a.first_difference(b).value();
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->tick, 125u);
    EXPECT_NE(difference->field, "");
}

TEST(PersistedWorld, replays_a_world_that_stopped_during_a_step) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    const server::HostLimits limits{.scene = {.bodies_max = 5000, .work_per_second_max = 1e12}};
    for (int life = 0; life < 6; life++) {
        auto archive =
            server::WorldArchive::open(
                {.database = path, .durability = "process", .history_retention_hours = 1}, limits,
                1, nullptr)
                .value();
        server::WorldDirectory worlds({.limits = limits, .world_persistence = archive.get()}, 4,
                                      "test");
        for (auto& kept : archive->take_worlds()) worlds.adopt(std::move(kept.start));
        auto world = worlds.find("");
        // Steps take most of a tick, so the world is usually in a step.
        scenes::SceneDescription pile = scenes::bench_pile(2500);
        pile.name = "pile";
        if (!world) world = worlds.create("pile", pile).value();
        const std::uint32_t tick = world->frame()->tick;
        while (world->frame()->tick < tick + 4) std::this_thread::sleep_for(1ms);
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * life));
        worlds.stop_all();
        ASSERT_TRUE(archive->flush(10s));
    }
    auto world = PersistedWorld::open(path, "pile").value();
    const auto verified = world.verify().value();
    EXPECT_EQ(verified.errors, std::vector<std::string>());
    EXPECT_GT(verified.checkpoints, 1);
}

TEST(PersistedWorld, reports_a_checkpoint_of_another_state) {
    const test::TempFolder folder;
    play(folder / "worlds.db", false);
    {
        auto store = server::SqliteStorage::open(folder / "worlds.db", {}).value();
        const std::string id = store->worlds().value().at(0).id;
        const std::uint32_t newest = store->checkpoint_ticks(id).value().front();
        auto checkpoint = store->checkpoint(id, newest).value();
        checkpoint.hash++;
        const server::StorageChange change[] = {server::PutCheckpoint{id, checkpoint}};
        EXPECT_TRUE(store->write(change).ok());
    }
    auto world = PersistedWorld::open(folder / "worlds.db", "yard").value();
    const auto verified = world.verify().value();
    ASSERT_EQ(verified.errors.size(), 1u);
    EXPECT_NE(verified.errors[0].find("differs from the replayed world"), std::string::npos);
}

TEST(PersistedWorld, adds_a_portable_checkpoint_of_the_last_tick) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    play(path, false);
    const auto added = PersistedWorld::open(path, "yard").value().add_portable().value();
    EXPECT_EQ(added.tick, 201u);
    EXPECT_GT(added.bytes, 500u);
    EXPECT_EQ(added.omitted, std::vector<std::string>());
    auto again = PersistedWorld::open(path, "yard").value();
    const auto verified = again.verify().value();
    EXPECT_EQ(verified.errors, std::vector<std::string>());
    EXPECT_EQ(verified.last_tick, 201u);
}

TEST(PersistedWorld, adds_no_portable_checkpoint_to_a_world_of_another_version) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    play(path, false);
    {
        auto store = server::SqliteStorage::open(path, {}).value();
        server::StoredWorld stored = store->worlds().value().at(0);
        stored.engine = "fused 99.0.0";
        stored.epoch++;
        const server::StorageChange change[] = {server::PutWorld{stored}};
        store->write(change).expect();
    }
    const Error refused = error_of(PersistedWorld::open(path, "yard").value().add_portable());
    EXPECT_EQ(refused.code, ErrorCode::failed_precondition);
    EXPECT_NE(refused.message.find("fused 99.0.0"), std::string::npos) << refused.message;
}

TEST(PersistedWorld, errors_name_the_missing_item_and_the_available_ones) {
    const test::TempFolder folder;
    play(folder / "worlds.db", false);
    EXPECT_EQ(error_of(PersistedWorld::open(folder / "worlds.db", "field")).message,
              folder / "worlds.db has no world \"field\"; it contains yard");
    EXPECT_EQ(error_of(PersistedWorld::open(folder / "world.db", "yard")).message,
              folder / "world.db: No such file or directory");
    EXPECT_EQ(error_of(PersistedWorld::open(folder / "world.db", "yard")).code,
              ErrorCode::not_found)
        << "opening must not create the file";
}

}  // namespace
}  // namespace jostle::replay
