// SPDX-License-Identifier: MIT
//
// Undo of the inputs of one client: the world continues as if they had not been sent.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/recovery/recover_world.h"
#include "server/recovery/world_archive.h"
#include "server/storage/sqlite_storage.h"
#include "server/world/world_directory.h"
#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;

constexpr ClientId griefer = 7, builder = 8;

SpawnCommand ball_at(double x) {
    SpawnCommand ball;
    ball.shape.geometry = physics::Sphere{0.3};
    ball.pose.position = {x, 6, 0};
    return ball;
}

// A server whose worlds the test ticks. Each world has the griefer, the builder, or both.
class Undoing : public testing::Test {
protected:
    Undoing() { start(); }
    ~Undoing() override { stop(); }

    void start() {
        PersistenceSettings settings;
        settings.database = path_;
        settings.durability = "process";
        settings.history_retention_hours = retention_hours_;
        const HostLimits limits{.scene = {.bodies_max = 400}, .bodies_owned_max = 60};
        archive_ = WorldArchive::open(settings, limits, 1, nullptr).value();
        worlds_.emplace(
            WorldHostSettings{
                .limits = limits, .own_ticks = false, .world_persistence = archive_.get()},
            8, "test");
        for (PersistedWorld& persisted : archive_->take_worlds())
            worlds_->adopt(std::move(persisted.start));
    }
    // Like a killed process: without final checkpoints.
    void stop() {
        if (!worlds_) return;
        EXPECT_TRUE(archive_->flush(5s));
        for (const auto& world : worlds_->list()) world->skip_final_checkpoint();
        worlds_->stop_all();
        worlds_.reset();
        archive_.reset();
    }
    std::shared_ptr<WorldHost> create(const std::string& name) {
        return worlds_->create(name, *scenes::find_scene("stack")).value();
    }
    void send(WorldHost& world, ClientId client, Action action) {
        world.mailbox().push({.client = client,
                              .sequence = ++sequences_[{world.id(), client}],
                              .action = std::move(action),
                              .reply = nullptr});
    }
    static void tick(WorldHost& world, int ticks = 1) {
        for (int k = 0; k < ticks; k++) world.tick(Clock::now());
    }
    // The builder throws a ball every tenth tick.
    void build(WorldHost& world, int ticks, const std::function<void()>& each = {}) {
        for (int k = 0; k < ticks; k++) {
            const std::uint32_t next = world.frame()->tick + 1;
            if (next % 10 == 0) send(world, builder, ball_at(0.001 * next));
            if (each) each();
            tick(world);
        }
    }
    // The griefer pushes boxes and throws balls.
    void grieve(WorldHost& world, int ticks) {
        build(world, ticks, [&] {
            const std::uint32_t next = world.frame()->tick + 1;
            send(world, griefer, ImpulseCommand{1 + next % 14, {30, 10, 0}, {}});
            if (next % 7 == 0) send(world, griefer, ball_at(-0.5));
        });
    }
    Result<WorldDirectory::Undone> undo(const std::shared_ptr<WorldHost>& world, ClientId client,
                                        int ticks) {
        EXPECT_TRUE(archive_->flush(5s));
        return worlds_->undo(world, client, ticks / world->hz());
    }

    struct Found {
        std::uint64_t hash = 0;
        std::map<EntityId, ClientId> owners;
    };
    // The last state of a stored world, recovered from every checkpoint with the same result.
    Found recovered(const std::string& name) {
        stop();
        const auto storage = SqliteStorage::open(path_, {}).value();
        const auto all = storage->worlds().value();
        const StoredWorld& stored = *std::ranges::find(all, name, &StoredWorld::name);
        const WorldDefinition definition = decode_world_definition(stored.settings).value();
        Found result;
        for (const std::uint32_t checkpoint : storage->checkpoint_ticks(stored.id).value()) {
            const RecoveredWorld found =
                recover_world(*storage, stored, definition, {.checkpoint = checkpoint}).value();
            EXPECT_EQ(found.warnings, std::vector<std::string>()) << "from " << checkpoint;
            const std::uint64_t hash = state_hash(found.world.world());
            EXPECT_TRUE(result.hash == 0 || result.hash == hash) << "from " << checkpoint;
            result.hash = hash;
            for (const auto& entity : found.world.host_state(found.tick).entities)
                result.owners[entity.id] = entity.owner;
        }
        return result;
    }

    double retention_hours_ = 1;
    const test::TempFolder folder_;
    const std::string path_ = folder_ / "worlds.db";
    std::unique_ptr<WorldArchive> archive_;
    std::optional<WorldDirectory> worlds_;
    std::map<std::pair<std::string, ClientId>, std::uint32_t> sequences_;
};

int owned_by(const WorldHost& world, ClientId client) {
    return static_cast<int>(std::ranges::count(*world.frame()->entity_list, client,
                                               [](const auto& entity) { return entity->owner; }));
}

std::vector<physics::Vec3> positions(const WorldHost& world) {
    std::vector<physics::Vec3> positions;
    for (const EntityPose& entity : world.frame()->entities)
        positions.push_back(entity.pose.position);
    return positions;
}

TEST_F(Undoing, world_continues_as_if_the_client_had_sent_nothing) {
    const auto yard = create("yard"), twin = create("twin");
    build(*yard, 30);
    build(*twin, 30);
    grieve(*yard, 40);
    build(*twin, 40);
    EXPECT_NE(positions(*yard), positions(*twin));
    EXPECT_EQ(owned_by(*yard, griefer), 6);
    std::vector<EntityId> built;
    for (const auto& entity : *yard->frame()->entity_list)
        if (entity->owner == builder) built.push_back(entity->id);
    const std::uint32_t before = yard->frame()->tick;
    const EntityId last_id = yard->frame()->entities.back().id;

    std::vector<ClientId> resumed;
    worlds_->on_replaced([&](const auto&, const auto& clients) { resumed = clients; });
    const auto undone = undo(yard, griefer, 40).value();
    EXPECT_EQ(undone.first_tick, before - 39);
    EXPECT_EQ(undone.inputs, 46u) << "40 impulses and six balls";
    EXPECT_EQ(resumed, (std::vector<ClientId>{griefer, builder})) << "both may resume";
    WorldHost& world = *undone.host;
    EXPECT_EQ(worlds_->find("yard"), undone.host);
    EXPECT_EQ(world.frame()->tick, before + 1);
    EXPECT_EQ(positions(world), positions(*twin)) << "to the bit";
    EXPECT_EQ(owned_by(world, griefer), 0);
    std::vector<EntityId> kept;
    for (const auto& entity : *world.frame()->entity_list)
        if (entity->owner == builder) kept.push_back(entity->id);
    EXPECT_EQ(kept, built) << "the bodies of the builder have the same ids";

    build(world, 30);
    for (int k = 0; k < 30; k++) {
        if ((twin->frame()->tick + 2) % 10 == 0)
            send(*twin, builder, ball_at(0.001 * (twin->frame()->tick + 2)));
        tick(*twin);
    }
    EXPECT_EQ(positions(world), positions(*twin));
    EXPECT_GT(world.frame()->entities.back().id, last_id) << "ids are not assigned again";
}

TEST_F(Undoing, recovery_afterwards_gives_the_same_world) {
    const auto yard = create("yard"), twin = create("twin");
    build(*yard, 30);
    build(*twin, 30);
    // Up to a tick with inputs, because a killed process loses the ticks after it.
    grieve(*yard, 39);
    build(*twin, 39);
    EXPECT_TRUE(undo(yard, griefer, 39).ok());
    const std::uint64_t hash = recovered("yard").hash;
    EXPECT_EQ(hash, recovered("twin").hash);
    start();
    EXPECT_EQ(owned_by(*worlds_->find("yard"), griefer), 0);
    build(*worlds_->find("yard"), 25);
    EXPECT_NE(recovered("yard").hash, hash);
}

TEST_F(Undoing, deletion_and_leaving) {
    const auto yard = create("yard");
    send(*yard, griefer, ball_at(1));
    build(*yard, 30);
    const EntityId ball = yard->frame()->entities.back().id - 2;
    ASSERT_EQ(owned_by(*yard, griefer), 1);
    send(*yard, griefer, DeleteCommand{ball - 1});
    send(*yard, griefer, DeleteCommand{ball});
    build(*yard, 20);
    yard->mailbox().push(
        {.client = griefer, .action = LeaveCommand{.retain_bodies = true}, .reply = nullptr});
    build(*yard, 10);
    EXPECT_EQ(owned_by(*yard, griefer), 0);
    std::vector<ClientId> resumed;
    worlds_->on_replaced([&](const auto&, const auto& clients) { resumed = clients; });
    const auto undone = undo(yard, griefer, 31).value();
    EXPECT_EQ(owned_by(*undone.host, griefer), 1) << "the body is there again";
    EXPECT_EQ(resumed, (std::vector<ClientId>{builder})) << "the griefer left";
}

TEST_F(Undoing, grab_from_before_ends_where_the_undo_begins) {
    const auto yard = create("yard");
    send(*yard, griefer, GrabCommand{10, {}});
    build(*yard, 10);
    const double before = yard->frame()->entities[9].pose.position.y;
    for (int k = 0; k < 40; k++) {
        send(*yard, griefer, DragCommand{{20, 20, 0}});
        build(*yard, 1);
    }
    const auto y_of = [](const WorldHost& world) {
        return world.frame()->entities[9].pose.position.y;
    };
    EXPECT_GT(y_of(*yard), before + 3);
    const auto undone = undo(yard, griefer, 40).value();
    EXPECT_EQ(undone.inputs, 40u);
    EXPECT_NEAR(y_of(*undone.host), before, 1);
}

TEST_F(Undoing, overlapping_undos_and_rewinds_replay_from_every_checkpoint) {
    auto yard = create("yard");
    const auto twin = create("twin");
    build(*yard, 30);
    build(*twin, 30);
    grieve(*yard, 20);
    yard = undo(yard, griefer, 20).value().host;  // in tick 52
    tick(*twin, 20);
    EXPECT_NE(positions(*yard), positions(*twin));
    grieve(*yard, 20);
    yard = undo(yard, griefer, 35).value().host;
    EXPECT_EQ(owned_by(*yard, griefer), 0);
    const std::vector<physics::Vec3> without_griefer = positions(*yard);
    const std::uint32_t at = yard->frame()->tick;
    // The undo covers both undos of the other client.
    yard = undo(yard, builder, 43).value().host;
    tick(*twin, 20);
    EXPECT_EQ(positions(*yard), positions(*twin)) << "nobody did anything since tick 31";
    EXPECT_TRUE(archive_->flush(5s));
    yard = worlds_->rewind(yard, at).value();
    EXPECT_EQ(positions(*yard), without_griefer) << "a rewind undoes the undo";
    yard = undo(yard, builder, 8).value().host;
    build(*yard, 12);
    EXPECT_NE(recovered("yard").hash, 0u);
}

// With the shortest history: the tick that the world was rewound to is no longer retained.
TEST_F(Undoing, time_may_include_a_rewind_beyond_the_history) {
    stop();
    retention_hours_ = 0;
    start();
    auto yard = create("yard");
    grieve(*yard, 20);
    EXPECT_TRUE(archive_->flush(5s));
    yard = worlds_->rewind(yard, 11).value();  // retains checkpoints of tick 21 and 22
    const std::vector<physics::Vec3> rewound = positions(*yard);
    build(*yard, 1);
    grieve(*yard, 20);
    const auto undone = undo(yard, griefer, 21).value();
    EXPECT_GT(undone.inputs, 20u);
    EXPECT_EQ(owned_by(*undone.host, griefer), 1) << "thrown before the tick of the rewind";
    EXPECT_NE(positions(*undone.host), rewound);
    recovered("yard");
}

// Stopping the world writes a checkpoint, after which the one before the undone time is deleted.
TEST_F(Undoing, works_with_the_shortest_history) {
    stop();
    retention_hours_ = 0;
    start();
    auto yard = create("yard");
    for (int round = 0; round < 4; round++) {
        grieve(*yard, 20);
        yard = undo(yard, griefer, 20).value().host;
        EXPECT_EQ(owned_by(*yard, griefer), 0);
        build(*yard, 10);
    }
    EXPECT_TRUE(archive_->flush(5s));
    yard = worlds_->rewind(yard, yard->oldest_restorable_tick()).value();
    build(*yard, 10);
    EXPECT_NE(recovered("yard").hash, 0u);
}

TEST_F(Undoing, history_bounds_the_time) {
    const auto yard = create("yard");
    grieve(*yard, 20);
    const auto undone = undo(yard, griefer, 3600).value();
    EXPECT_EQ(undone.first_tick, 2u);
    EXPECT_EQ(owned_by(*undone.host, griefer), 0);
}

TEST_F(Undoing, world_continues_unchanged_if_there_is_nothing_to_undo) {
    const auto yard = create("yard");
    build(*yard, 20);
    const Error refused = error_of(undo(yard, griefer, 10));
    EXPECT_EQ(refused.code, ErrorCode::not_found);
    EXPECT_EQ(refused.message, "client 7 has no inputs since tick 12");
    EXPECT_FALSE(yard->lifecycle().stopped());
    WorldDirectory transient({.own_ticks = false}, 8, "test");
    const auto world = transient.create("yard", *scenes::find_scene("stack")).value();
    EXPECT_EQ(error_of(transient.undo(world, griefer, 10)).code, ErrorCode::failed_precondition);
}

}  // namespace
}  // namespace jostle::server
