// SPDX-License-Identifier: MIT
#include "server/recovery/portable_checkpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/world_archive.h"
#include "server/storage/compression.h"
#include "server/storage/sqlite_storage.h"
#include "server/util/bytes.h"
#include "server/world/world_directory.h"
#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;

// A server of one world, which the test ticks.
struct Server {
    explicit Server(const std::string& path, bool accept_damage = false) {
        PersistenceSettings settings;
        settings.database = path;
        settings.durability = "process";
        settings.accept_damage = accept_damage;
        const HostLimits limits{.scene = {.bodies_max = 400}, .bodies_owned_max = 30};
        archive = WorldArchive::open(settings, limits, 1, nullptr).value();
        worlds.emplace(
            WorldHostSettings{
                .limits = limits, .own_ticks = false, .world_persistence = archive.get()},
            8, "test");
        for (PersistedWorld& persisted : archive->take_worlds()) {
            previous_clients = persisted.previous_clients;
            worlds->adopt(std::move(persisted.start));
        }
    }
    ~Server() {
        worlds->stop_all();
        EXPECT_TRUE(archive->flush(5s));
    }
    std::shared_ptr<WorldHost> world() { return worlds->find("yard"); }
    // Client 7 throws a ball every tenth tick.
    void play(int ticks) {
        for (int k = 0; k < ticks; k++) {
            const std::uint32_t tick = world()->frame()->tick + 1;
            if (tick % 10 == 0) {
                SpawnCommand ball;
                ball.shape.geometry = physics::Sphere{0.3};
                ball.pose.position = {0.5, 6, 0};
                world()->mailbox().push(
                    {.client = 7, .sequence = tick, .action = ball, .reply = nullptr});
            }
            world()->tick(Clock::now());
        }
    }

    std::unique_ptr<WorldArchive> archive;
    std::optional<WorldDirectory> worlds;
    std::vector<PreviousClient> previous_clients;
};

// A database with a world of 61 ticks and six balls, closed; returns its last frame.
FramePtr play_once(const std::string& path, const char* scene = "stack") {
    Server server(path);
    server.worlds->create("yard", *scenes::find_scene(scene)).value();
    server.play(60);
    return server.world()->frame();
}

struct Stored {
    explicit Stored(const std::string& path)
        : storage(SqliteStorage::open(path, {}).value()), world(storage->worlds().value().at(0)) {}
    Checkpoint newest() {
        return storage->checkpoint(world.id, storage->checkpoint_ticks(world.id).value().front())
            .value();
    }
    void put(const Checkpoint& checkpoint) {
        const StorageChange change[] = {PutCheckpoint{world.id, checkpoint}};
        storage->write(change).expect();
    }

    std::unique_ptr<SqliteStorage> storage;
    StoredWorld world;
};

std::string of_later_version() {
    ByteWriter to;
    to.number(99);
    return to.take();
}

// What jostle-replay --add-portable of a later version leaves behind.
void upgrade(const std::string& path, bool with_portable = true) {
    Stored stored(path);
    const WorldDefinition definition = decode_world_definition(stored.world.settings).value();
    RecoveredWorld found = recover_world(*stored.storage, stored.world, definition, {}).value();
    Checkpoint checkpoint = make_checkpoint(found.world, found.tick, found.sequence).value();
    checkpoint.exact = compress(of_later_version());
    if (with_portable)
        checkpoint.portable = encode_portable(found.world, found.tick, definition).bytes;
    stored.put(checkpoint);
}

std::map<EntityId, physics::Vec3> positions(const Frame& frame) {
    std::map<EntityId, physics::Vec3> positions;
    for (const EntityPose& entity : frame.entities) positions[entity.id] = entity.pose.position;
    return positions;
}

TEST(PortableCheckpoint, older_version_resumes_a_world_of_a_later_one) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    const FramePtr before = play_once(path);
    upgrade(path);
    std::uint32_t tick = 0;
    {
        Server server(path);
        ASSERT_NE(server.world(), nullptr);
        const FramePtr after = server.world()->frame();
        EXPECT_EQ(after->tick, before->tick);
        EXPECT_EQ(positions(*after), positions(*before)) << "ids and poses";
        int owned = 0;
        for (const auto& entity : *after->entity_list) owned += entity->owner == 7 ? 1 : 0;
        EXPECT_EQ(owned, 6);
        ASSERT_EQ(server.previous_clients.size(), 1u) << "the client may resume";
        EXPECT_EQ(server.previous_clients[0].client, 7u);
        EXPECT_EQ(server.previous_clients[0].last_sequence, 60u);
        server.play(40);
        tick = server.world()->frame()->tick;
        EXPECT_EQ(server.world()->frame()->entities.back().id, before->entities.back().id + 4);
    }
    // From now on it is a world of this version, whose history begins at the downgrade.
    Stored stored(path);
    EXPECT_EQ(stored.storage->checkpoint_ticks(stored.world.id).value().back(), before->tick);
    const WorldDefinition definition = decode_world_definition(stored.world.settings).value();
    const RecoveredWorld found =
        recover_world(*stored.storage, stored.world, definition, {.checkpoint = before->tick})
            .value();
    EXPECT_EQ(found.warnings, std::vector<std::string>());
    EXPECT_EQ(found.tick, tick);
    EXPECT_EQ(state_hash(found.world.world()), stored.newest().hash);
}

TEST(PortableCheckpoint, recovery_result_says_what_is_lost_and_why) {
    const test::TempFolder folder;
    play_once(folder / "worlds.db");
    upgrade(folder / "worlds.db");
    Stored stored(folder / "worlds.db");
    const WorldDefinition definition = decode_world_definition(stored.world.settings).value();
    const RecoveredWorld found =
        recover_world(*stored.storage, stored.world, definition, {}).value();
    EXPECT_TRUE(found.is_portable);
    EXPECT_FALSE(found.is_cut);
    EXPECT_EQ(found.scene->bodies.size(), definition.scene->bodies.size() + 6);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_EQ(found.warnings[0],
              "recovered from the portable form of the checkpoint of tick 61 without accumulated "
              "impulses, sleep and grabs: unsupported checkpoint: version 99; this server reads "
              "version 1");
}

TEST(PortableCheckpoint, scene_with_modules_keeps_its_bodies) {
    const test::TempFolder folder;
    const FramePtr before = play_once(folder / "worlds.db", "sandbox");
    upgrade(folder / "worlds.db");
    Server server(folder / "worlds.db");
    ASSERT_NE(server.world(), nullptr);
    EXPECT_EQ(server.world()->frame()->entities.size(), before->entities.size());
    server.play(30);
    for (const auto& [id, position] : positions(*server.world()->frame()))
        EXPECT_TRUE(std::isfinite(position.x)) << id;
}

TEST(PortableCheckpoint, replaces_a_definition_of_a_later_version) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    const FramePtr before = play_once(path);
    upgrade(path);
    {
        Stored stored(path);
        stored.world.settings = of_later_version();
        stored.world.epoch++;
        const StorageChange change[] = {PutWorld{stored.world}};
        stored.storage->write(change).expect();
    }
    Server server(path);
    ASSERT_NE(server.world(), nullptr);
    EXPECT_EQ(positions(*server.world()->frame()), positions(*before));
    EXPECT_EQ(server.world()->properties().scene->name, "stack");
}

TEST(PortableCheckpoint, damaged_exact_form_is_not_replaced) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    play_once(path);
    upgrade(path);
    Stored stored(path);
    const WorldDefinition definition = decode_world_definition(stored.world.settings).value();
    Checkpoint damaged = stored.newest();
    damaged.exact[damaged.exact.size() / 2] ^= 1;
    stored.put(damaged);
    const RecoveredWorld found =
        recover_world(*stored.storage, stored.world, definition, {}).value();
    EXPECT_FALSE(found.is_portable);
    EXPECT_EQ(found.checkpoint, 1u) << "the older checkpoint and the journal are exact";
    EXPECT_EQ(found.tick, 61u);
    EXPECT_EQ(
        error_of(recover_world(*stored.storage, stored.world, definition, {.checkpoint = 61})).code,
        ErrorCode::corrupt_data);
}

TEST(PortableCheckpoint, later_ticks_are_lost_only_if_that_is_accepted) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    play_once(path);
    upgrade(path);
    {
        // As if the later version had continued after the portable checkpoint.
        Stored stored(path);
        Checkpoint checkpoint = stored.newest();
        const auto entries =
            stored.storage->entries(stored.world.id, checkpoint.sequence - 2, 1 << 20).value();
        checkpoint.sequence -= 2;
        checkpoint.tick = entries.front().first_tick - 1;
        const StorageChange changes[] = {
            TruncateJournal{stored.world.id, checkpoint.tick, entries.back().sequence},
            PutCheckpoint{stored.world.id, checkpoint}};
        stored.storage->write(changes).expect();
    }
    {
        Server server(path);
        EXPECT_EQ(server.world(), nullptr);
        ASSERT_TRUE(server.archive->damage().has_value());
        EXPECT_NE(server.archive->damage()->find("--add-portable"), std::string::npos)
            << *server.archive->damage();
    }
    Server server(path, true);
    EXPECT_NE(server.world(), nullptr);
}

TEST(PortableCheckpoint, error_without_a_portable_form_names_the_tool) {
    const test::TempFolder folder;
    play_once(folder / "worlds.db");
    upgrade(folder / "worlds.db", false);
    Stored stored(folder / "worlds.db");
    const WorldDefinition definition = decode_world_definition(stored.world.settings).value();
    const Error refused =
        error_of(recover_world(*stored.storage, stored.world, definition, {.checkpoint = 61}));
    EXPECT_EQ(refused.code, ErrorCode::failed_precondition);
    EXPECT_NE(refused.message.find("jostle-replay --add-portable"), std::string::npos)
        << refused.message;
}

TEST(PortableCheckpoint, altered_bytes_are_rejected_or_make_a_consistent_world) {
    const test::TempFolder folder;
    play_once(folder / "worlds.db");
    upgrade(folder / "worlds.db");
    const std::string whole =
        decompress(Stored(folder / "worlds.db").newest().portable, 1 << 20).value();
    const HostLimits limits{.scene = {.bodies_max = 400}};
    EXPECT_TRUE(decode_portable(compress(whole), 61, limits, 1).ok());
    EXPECT_TRUE(decode_portable(compress(whole + "fields of a later version"), 61, limits, 1).ok());
    EXPECT_EQ(error_of(decode_portable(compress(of_later_version()), 61, limits, 1)).code,
              ErrorCode::failed_precondition);
    for (std::size_t size = 0; size < whole.size(); size += size < 40 ? 1 : 53)
        EXPECT_EQ(error_of(decode_portable(compress(whole.substr(0, size)), 61, limits, 1)).code,
                  ErrorCode::corrupt_data)
            << size;
    for (std::size_t at = 0; at < whole.size(); at += 37) {
        std::string altered = whole;
        altered[at] ^= 4;
        static_cast<void>(decode_portable(compress(altered), 61, limits, 1).ok());
    }
}

}  // namespace
}  // namespace jostle::server
