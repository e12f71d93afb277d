// SPDX-License-Identifier: MIT
#include "server/recovery/world_archive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/recovery/journal_codec.h"
#include "server/recovery/recover_world.h"
#include "server/storage/sqlite_storage.h"
#include "server/world/world_directory.h"
#include "tests/server/storage/damaged_disk.h"
#include "tests/support/error_of.h"
#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;

HostLimits limits() {
    return {.scene = {.bodies_max = 400}, .bodies_owned_max = 30};
}

// The components of a server that own its worlds: an archive and a directory. The test calls the
// ticks.
class Process {
public:
    explicit Process(std::string path, PersistenceSettings settings = {}) {
        settings.database = std::move(path);
        settings.durability = "process";
        auto opened = WorldArchive::open(settings, limits(), 1, [this] { results_sent++; });
        archive = std::move(opened).value();
        hosts.limits = limits();
        hosts.own_ticks = false;
        hosts.world_persistence = archive.get();
        worlds.emplace(hosts, 8, "test");
        for (PersistedWorld& kept : archive->take_worlds()) {
            previous_clients = kept.previous_clients;
            worlds->adopt(std::move(kept.start));
        }
    }
    std::shared_ptr<WorldHost> create(const std::string& name) {
        return worlds->create(name, *scenes::find_scene("stack")).value();
    }
    // Two players for `ticks` ticks. Their inputs depend only on the tick.
    static void play(WorldHost& world, int ticks, const std::shared_ptr<ResultQueue>& reply) {
        for (int k = 0; k < ticks; k++) {
            const std::uint32_t tick = world.frame()->tick + 1;
            test::Random random(tick);
            for (ClientId client = 1; client <= 2; client++) {
                SpawnCommand ball;
                ball.shape.geometry = physics::Sphere{0.3};
                ball.pose.position = random.vector(3) + physics::Vec3{0, 8, 0};
                const auto any = static_cast<EntityId>(1 + random.below(14));
                const Action actions[] = {ball, ImpulseCommand{any, random.vector(20), {}},
                                          GrabCommand{any, random.vector(1)},
                                          DragCommand{random.vector(6)}, DeleteCommand{any}};
                world.mailbox().push({.client = client,
                                      .sequence = tick,
                                      .action = actions[random.below(5)],
                                      .reply = reply});
            }
            world.tick(Clock::now());
        }
    }
    // Ends like a killed process: pending writes may be lost and clients are not notified.
    void kill() {
        for (const auto& world : worlds->list()) world->skip_final_checkpoint();
        worlds->stop_all();
        worlds.reset();
        archive.reset();
    }

    std::atomic<int> results_sent = 0;
    std::unique_ptr<WorldArchive> archive;
    WorldHostSettings hosts;
    std::optional<WorldDirectory> worlds;
    std::vector<PreviousClient> previous_clients;
};

// The state hash of a world that the test ticks. The world does not step meanwhile.
std::uint64_t hash_of(WorldHost& world) {
    std::uint64_t hash = 0;
    world.pause("for inspection");
    std::jthread visitor([&] {
        world.between_ticks()
            .run([&](HostedWorld& hosted) { hash = state_hash(hosted.world()); })
            .expect();
    });
    while (hash == 0) {
        world.tick(Clock::now());
        std::this_thread::sleep_for(1ms);
    }
    return hash;
}

// The room of a world that the test ticks and that hash_of() paused.
RoomState room_of(WorldHost& world) {
    std::optional<RoomState> room;
    std::atomic<bool> done = false;
    std::jthread visitor([&] {
        world.between_ticks()
            .run([&](HostedWorld& hosted) { room = hosted.room()->state(); })
            .expect();
        done = true;
    });
    while (!done) {
        world.tick(Clock::now());
        std::this_thread::sleep_for(1ms);
    }
    return *room;
}

struct RecoveredState {
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;
};
// The state of a stored world after recovery up to a tick.
RecoveredState persisted_worlds_in(const std::string& path, std::uint32_t tick) {
    auto store = SqliteStorage::open(path, {}).value();
    const StoredWorld stored = store->worlds().value().at(0);
    const WorldDefinition record = decode_world_definition(stored.settings).value();
    RecoveredWorld found = recover_world(*store, stored, record, {.last_tick = tick}).value();
    EXPECT_TRUE(found.warnings.empty());
    return {found.tick, state_hash(found.world.world())};
}

TEST(WorldArchive, world_is_bit_identical_after_three_killed_processes) {
    const test::TempFolder folder;
    const auto reply = std::make_shared<ResultQueue>();
    // The same world without interruption.
    const auto alone = WorldHost::start("w1", "alone", *scenes::find_scene("stack"),
                                        {.limits = limits(), .own_ticks = false})
                           .value();
    for (int life = 0; life < 4; life++) {
        Process process(folder / "worlds.db");
        const auto world = life == 0 ? process.create("yard") : process.worlds->find("yard");
        ASSERT_NE(world, nullptr);
        EXPECT_EQ(world->frame()->tick, 1u + 50u * static_cast<unsigned>(life));
        if (life > 0) {
            EXPECT_EQ(process.previous_clients.size(), 2u) << "the players may resume";
            EXPECT_EQ(process.previous_clients[0].last_sequence, world->frame()->tick);
        }
        Process::play(*world, 50, reply);
        Process::play(*alone, 50, std::make_shared<ResultQueue>());
        EXPECT_TRUE(process.archive->flush(5s));
        EXPECT_EQ(reply->take().size(), 100u) << "each input must have one result";
        process.kill();
    }
    const std::uint32_t tick = alone->frame()->tick;
    EXPECT_EQ(persisted_worlds_in(folder / "worlds.db", tick).hash, hash_of(*alone));
}

TEST(WorldArchive, bodies_removed_by_the_host_stay_removed_after_recovery) {
    const test::TempFolder folder;
    const auto reply = std::make_shared<ResultQueue>();
    Process process(folder / "worlds.db");
    const auto world = process.create("yard");
    Process::play(*world, 50, reply);
    std::size_t removed = 0;
    std::jthread operation([&] {
        world->between_ticks()
            .run([&](HostedWorld& hosted) { removed = hosted.remove_bodies_of(1); })
            .expect();
    });
    while (removed == 0) {
        Process::play(*world, 1, reply);
        std::this_thread::sleep_for(1ms);
    }
    operation.join();
    Process::play(*world, 30, reply);
    ASSERT_TRUE(process.archive->flush(5s));
    const std::uint32_t tick = world->frame()->tick;
    const std::uint64_t hash = hash_of(*world);
    EXPECT_GT(removed, 3u);
    process.kill();
    EXPECT_EQ(persisted_worlds_in(folder / "worlds.db", tick).hash, hash);
}

// An input whose result says that it was refused must not be applied after a restart.
TEST(WorldArchive, refused_inputs_count_after_recovery) {
    const test::TempFolder folder;
    const auto reply = std::make_shared<ResultQueue>();
    std::size_t refused = 0;
    {
        Process process(folder / "worlds.db");
        process.hosts.body_limits.account_bodies_max = 3;
        process.worlds.reset();
        process.worlds.emplace(process.hosts, 8, "test");
        const auto world = process.create("yard");
        for (std::uint32_t sequence = 1; sequence <= 10; sequence++) {
            SpawnCommand ball;
            ball.shape.geometry = physics::Sphere{0.2};
            ball.pose.position = {0, 5.0 + sequence, 0};
            world->mailbox().push(
                {.client = 1, .account = 9, .sequence = sequence, .action = ball, .reply = reply});
            world->tick(Clock::now());
        }
        ASSERT_TRUE(process.archive->flush(5s));
        for (const InputResult& result : reply->take()) refused += result.status.ok() ? 0 : 1;
        process.kill();
    }
    EXPECT_EQ(refused, 7u);
    Process process(folder / "worlds.db");
    ASSERT_EQ(process.previous_clients.size(), 1u);
    EXPECT_EQ(process.previous_clients[0].last_sequence, 10u);
}

TEST(WorldArchive, clean_shutdown_writes_a_final_checkpoint) {
    const test::TempFolder folder;
    std::uint32_t tick = 0;
    {
        Process process(folder / "worlds.db");
        const auto world = process.create("yard");
        Process::play(*world, 30, std::make_shared<ResultQueue>());
        tick = world->frame()->tick;
        process.worlds->stop_all();
        EXPECT_TRUE(process.archive->flush(5s));
    }
    auto store = SqliteStorage::open(folder / "worlds.db", {}).value();
    const std::string id = store->worlds().value().at(0).id;
    EXPECT_EQ(store->checkpoint_ticks(id).value().front(), tick);
}

TEST(WorldArchive, deleted_world_is_not_restored_and_client_ids_are_not_reused) {
    const test::TempFolder folder;
    ClientId first = 0;
    {
        Process process(folder / "worlds.db");
        process.create("yard");
        process.create("field");
        process.worlds->remove("yard");
        first = process.archive->first_client();
        process.kill();
    }
    Process process(folder / "worlds.db");
    EXPECT_EQ(process.worlds->find("yard"), nullptr);
    EXPECT_NE(process.worlds->find("field"), nullptr);
    EXPECT_GT(process.archive->first_client(), first + 1000);
    EXPECT_EQ(process.create("yard")->id(), "w3-test") << "world numbers must continue";
}

TEST(WorldArchive, writes_periodic_checkpoints_and_retains_two) {
    const test::TempFolder folder;
    Process process(folder / "worlds.db", {.replay_seconds_max = 0.01});
    const auto world = process.create("yard");
    for (int k = 0; k < 60; k++) {
        Process::play(*world, 10, std::make_shared<ResultQueue>());
        ASSERT_TRUE(process.archive->flush(5s));
    }
    const std::string id = world->id();
    auto copy = process.archive->copy_of(id, 0xffffffff).value();
    const auto ticks = copy->checkpoint_ticks(id).value();
    EXPECT_EQ(ticks.size(), 2u);
    EXPECT_GT(ticks.back(), 300u);
    process.kill();
    auto store = SqliteStorage::open(folder / "worlds.db", {}).value();
    EXPECT_EQ(store->checkpoint_ticks(id).value(), ticks);
    EXPECT_GT(store->entries(id, 0, 1).error().message.size(), 0u)
        << "the first entries must be trimmed";
}

TEST(WorldArchive, exports_a_past_tick_of_a_running_world) {
    const test::TempFolder folder;
    Process process(folder / "worlds.db");
    const auto world = process.create("yard");
    Process::play(*world, 40, std::make_shared<ResultQueue>());
    ASSERT_TRUE(process.archive->flush(5s));
    const std::size_t now = world->frame()->entities.size();
    const auto then = process.worlds->scene_at(*world, 11).value();
    EXPECT_LT(then.scene.bodies.size(), now);
    EXPECT_EQ(process.worlds->scene_at(*world, 41).value().scene.bodies.size(), now);
    EXPECT_TRUE(process.worlds->create("what-if", then.scene).ok());
    EXPECT_EQ(error_of(process.worlds->scene_at(*world, 900)).message,
              "tick 900 is not retained; the last retained tick is 41");
}

// Two players, 80 ticks, rewound to tick 41 and continued. Ticks, ids and input sequences continue
// to increase.
TEST(WorldArchive, rewind_preserves_the_history_in_between) {
    const test::TempFolder folder;
    const auto reply = std::make_shared<ResultQueue>();
    std::uint64_t at_the_end = 0;
    std::uint32_t last_tick = 0;
    {
        Process process(folder / "worlds.db", {.history_retention_hours = 1});
        const auto first = process.create("yard");
        Process::play(*first, 40, reply);
        const std::uint64_t then = hash_of(*first);
        const std::uint32_t back_to = first->frame()->tick;
        const EntityId then_id = first->frame()->entities.back().id;
        first->resume();
        Process::play(*first, 40, reply);
        const std::uint32_t played = first->frame()->tick;
        const EntityId last_id = first->frame()->entities.back().id;
        const std::uint64_t later = hash_of(*first);
        const std::uint32_t newest = first->frame()->tick;
        first->resume();
        ASSERT_TRUE(process.archive->flush(5s));
        EXPECT_EQ(error_of(process.worlds->rewind(first, 900)).code, ErrorCode::not_found);
        EXPECT_FALSE(first->lifecycle().stopped())
            << "the world must continue if the tick is not retained";

        std::vector<ClientId> resumed_clients;
        process.worlds->on_replaced(
            [&](const auto&, const std::vector<ClientId>& clients) { resumed_clients = clients; });
        const auto again = process.worlds->rewind(first, back_to).value();
        EXPECT_EQ(resumed_clients, (std::vector<ClientId>{1, 2}));
        EXPECT_TRUE(first->lifecycle().was_replaced());
        EXPECT_EQ(process.worlds->find("yard"), again);
        EXPECT_EQ(again->id(), first->id());
        EXPECT_EQ(again->properties().first_tick, newest + 1);
        EXPECT_EQ(hash_of(*again), then);
        again->resume();
        EXPECT_EQ(error_of(process.worlds->rewind(first, back_to)).code, ErrorCode::aborted)
            << "a stopped host must be rejected";

        const auto late = std::make_shared<ResultQueue>();
        again->mailbox().push(
            {.client = 1, .sequence = played, .action = ReleaseCommand{}, .reply = late});
        again->tick(Clock::now());
        ASSERT_TRUE(process.archive->flush(5s));
        EXPECT_FALSE(late->take().at(0).status.ok())
            << "a sequence from before the rewind must be rejected";
        Process::play(*again, 30, reply);
        EXPECT_GT(again->frame()->entities.back().id, last_id);
        for (const auto& entity : again->frame()->entities)
            EXPECT_TRUE(entity.id <= then_id || entity.id > last_id) << entity.id;
        last_tick = again->frame()->tick;
        at_the_end = hash_of(*again);
        again->resume();
        ASSERT_TRUE(process.archive->flush(5s));
        // The undone history is still stored, so the world can return to it.
        const auto undone = process.worlds->rewind(again, newest).value();
        EXPECT_EQ(hash_of(*undone), later);
        undone->resume();
        const auto redone = process.worlds->rewind(undone, last_tick).value();
        EXPECT_EQ(hash_of(*redone), at_the_end);
        process.kill();
    }
    // Recovery from the first checkpoint through all three rewinds gives the same state as recovery
    // from the last one.
    auto store = SqliteStorage::open(folder / "worlds.db", {}).value();
    const StoredWorld stored = store->worlds().value().at(0);
    const WorldDefinition record = decode_world_definition(stored.settings).value();
    for (const std::uint32_t checkpoint : store->checkpoint_ticks(stored.id).value()) {
        const RecoveredWorld found =
            recover_world(*store, stored, record, {.checkpoint = checkpoint}).value();
        EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
        EXPECT_EQ(state_hash(found.world.world()), at_the_end) << "from " << checkpoint;
    }
}

TEST(WorldArchive, room_is_identical_after_a_killed_process_and_a_reset) {
    const test::TempFolder folder;
    const auto reply = std::make_shared<ResultQueue>();
    const auto command = [](WorldHost& world, RoomCommand about_room) {
        world.mailbox().push({.client = 1,
                              .sequence = world.frame()->tick + 1,
                              .action = std::move(about_room),
                              .reply = nullptr});
        world.tick(Clock::now());
    };
    std::uint64_t hash = 0;
    RoomState room;
    for (int run = 0; run < 3; run++) {
        Process process(folder / "worlds.db");
        std::shared_ptr<WorldHost> world = process.worlds->find("yard");
        if (run == 0) {
            RoomProperties properties;
            ASSERT_TRUE(set_quota(properties, "player.energy_per_second", 500).ok());
            world = process.worlds->create("yard", *scenes::find_scene("stack"), "ada", properties)
                        .value();
            world->mailbox().enter(1, {.member = "subject/ada"});
            world->mailbox().enter(2, {.member = "subject/eve"});
        } else {
            ASSERT_TRUE(world);
            EXPECT_EQ(hash_of(*world), hash);
            EXPECT_EQ(room_of(*world), room);
            world->resume();
        }
        Process::play(*world, 50, reply);
        if (run == 0) command(*world, {ProtectArea{{"tower", {-1, 0, -1}, {1, 9, 1}}}});
        if (run == 1) world = process.worlds->reset(world).value();
        command(*world, {MuteClient{2, 60}});
        Process::play(*world, 20, reply);
        hash = hash_of(*world);
        room = room_of(*world);
        EXPECT_EQ(room.clients.size(), 2u);
        EXPECT_EQ(room.properties.areas.size(), 1u);
        EXPECT_NE(room.clients[1].muted_until, 0u);
        ASSERT_TRUE(process.archive->flush(5s));
        process.kill();
    }
}

TEST(WorldArchive, creates_a_world_from_a_past_tick_without_clients) {
    const test::TempFolder folder;
    std::string id;
    std::uint64_t hash = 0;
    std::uint32_t tick = 0;
    {
        Process process(folder / "worlds.db");
        const auto yard = process.create("yard");
        Process::play(*yard, 40, std::make_shared<ResultQueue>());
        ASSERT_TRUE(process.archive->flush(5s));
        EXPECT_EQ(yard->oldest_restorable_tick(), 1u);
        EXPECT_EQ(error_of(process.worlds->create_from("yard", *yard, 31)).code,
                  ErrorCode::already_exists);
        const auto what_if = process.worlds->create_from("what-if", *yard, 31, "ada").value();
        EXPECT_EQ(what_if->frame()->tick, 31u);
        EXPECT_EQ(what_if->properties().label.owner, "ada");
        EXPECT_TRUE(process.worlds->remove("yard"));
        Process::play(*what_if, 10, std::make_shared<ResultQueue>());
        id = what_if->id();
        tick = what_if->frame()->tick;
        hash = hash_of(*what_if);
        ASSERT_TRUE(process.archive->flush(5s));
        process.kill();
    }
    EXPECT_EQ(persisted_worlds_in(folder / "worlds.db", tick).hash, hash);
    Process process(folder / "worlds.db");
    EXPECT_NE(process.worlds->find(id), nullptr);
}

TEST(WorldArchive, skips_commands_of_a_tick_that_crashed_twice) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db";
    std::string id;
    {
        Process process(path);
        const auto world = process.create("yard");
        id = world->id();
        Process::play(*world, 20, std::make_shared<ResultQueue>());
        ASSERT_TRUE(process.archive->flush(5s));
        process.kill();
    }
    {
        const auto marks = CrashMarkers::open(path + ".marks").value();
        for (int crash = 0; crash < 2; crash++) {
            marks->of(id).begin(15);
            marks->on_crash();
        }
    }
    {
        Process process(path);
        EXPECT_EQ(process.worlds->find("yard")->frame()->tick, 21u);
        process.kill();
    }
    auto store = SqliteStorage::open(path, {}).value();
    const auto aside = store->note("aside " + id + " 15").value();
    ASSERT_TRUE(aside.has_value());
    EXPECT_EQ(decode_journal(*aside).value().ticks.at(0).commands.size(), 2u);
    EXPECT_EQ(store->note("aside " + id + " 14").value(), std::nullopt);
}

// ---- damage ----

const char* const file_names[] = {"worlds.db", "worlds.db-wal", "worlds.db.head"};

test::FileContents files_of(const test::TempFolder& folder) {
    test::FileContents files;
    for (const char* name : file_names) files[name] = folder.read(name);
    return files;
}

// The files that SIGKILL leaves of a process with a world of 201 ticks, and those of an earlier
// tick.
struct KilledServer {
    test::FileContents files, older;
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;
};
KilledServer killed_server() {
    const test::TempFolder folder;
    KilledServer killed;
    // A checkpoint empties the log; its time depends on the machine, so there is none after the
    // first.
    Process process(folder / "worlds.db", {.replay_seconds_max = 3600});
    const auto world = process.create("yard");
    for (int k = 0; k < 20; k++) {
        Process::play(*world, 10, std::make_shared<ResultQueue>());
        EXPECT_TRUE(process.archive->flush(5s));
        if (k == 14) killed.older = files_of(folder);
    }
    killed.files = files_of(folder);
    killed.tick = world->frame()->tick;
    killed.hash = hash_of(*world);
    process.kill();
    return killed;
}
void write_files(const test::TempFolder& folder, const test::FileContents& files) {
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
        std::filesystem::remove(entry);
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
}

TEST(WorldArchive, does_not_resume_an_older_world_unless_that_is_accepted) {
    const test::TempFolder folder;
    KilledServer killed = killed_server();
    std::string& log = killed.files["worlds.db-wal"];
    ASSERT_GT(log.size(), 5000u);
    log.resize(log.size() - 4000);
    write_files(folder, killed.files);
    {
        Process process(folder / "worlds.db");
        EXPECT_EQ(process.worlds->find("yard"), nullptr);
        ASSERT_TRUE(process.archive->damage().has_value());
        const Error refused =
            error_of(process.worlds->create("yard", *scenes::find_scene("stack")));
        EXPECT_EQ(refused.code, ErrorCode::failed_precondition);
        EXPECT_NE(refused.message.find("missing"), std::string::npos) << refused.message;
        process.kill();
    }
    EXPECT_EQ(folder.read("worlds.db-wal").size() <= log.size(), true);
    {
        Process process(folder / "worlds.db", {.accept_damage = true});
        const auto world = process.worlds->find("yard");
        ASSERT_NE(world, nullptr);
        EXPECT_LT(world->frame()->tick, killed.tick);
        EXPECT_GT(world->frame()->tick, 100u);
        EXPECT_FALSE(process.archive->damage().has_value());
        process.kill();
    }
    int copies = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
        copies += entry.path().string().find(".damaged-") != std::string::npos ? 1 : 0;
    EXPECT_EQ(copies, 3) << "the files as they were";
    Process process(folder / "worlds.db");
    EXPECT_NE(process.worlds->find("yard"), nullptr) << "accepted once and for all";
}

TEST(WorldArchive, whole_recoveries_of_damaged_files_report_it_or_are_bit_identical) {
    const KilledServer killed = killed_server();
    const test::TempFolder folder;
    const int damages = test::damages_to_try(60);
    test::Random random(5);
    int reports = 0;
    for (int k = 0; k < damages; k++) {
        test::FileContents files = killed.files;
        const std::string what = test::damage_one_file(files, killed.older, random);
        write_files(folder, files);
        PersistenceSettings settings;
        settings.database = folder / "worlds.db";
        settings.durability = "process";
        auto archive = WorldArchive::open(settings, limits(), 1, nullptr);
        if (!archive.ok() || (*archive)->damage()) {
            reports++;
            continue;
        }
        std::vector<PersistedWorld> worlds = (*archive)->take_worlds();
        ASSERT_EQ(worlds.size(), 1u) << what << " is silent";
        EXPECT_EQ(worlds[0].start.tick, killed.tick) << what << " is silent";
        EXPECT_EQ(state_hash(worlds[0].start.world.world()), killed.hash) << what << " is silent";
    }
    EXPECT_GT(reports, damages / 4);
    RecordProperty("reports", reports);
}

TEST(WorldArchive, falls_back_to_the_previous_checkpoint_when_one_is_corrupt) {
    const test::TempFolder folder;
    std::string id;
    std::uint32_t tick = 0;
    {
        Process process(folder / "worlds.db", {.replay_seconds_max = 0.01});
        const auto world = process.create("yard");
        id = world->id();
        for (int k = 0; k < 20; k++) {
            Process::play(*world, 10, std::make_shared<ResultQueue>());
            ASSERT_TRUE(process.archive->flush(5s));
        }
        tick = world->frame()->tick;
        process.kill();
    }
    const RecoveredState whole = persisted_worlds_in(folder / "worlds.db", tick);
    EXPECT_EQ(whole.tick, tick);
    {
        auto store = SqliteStorage::open(folder / "worlds.db", {}).value();
        Checkpoint newest =
            store->checkpoint(id, store->checkpoint_ticks(id).value().front()).value();
        newest.exact[newest.exact.size() / 2] ^= 1;
        const StorageChange change[] = {PutCheckpoint{id, newest}};
        store->write(change).expect();
        const StoredWorld stored = store->worlds().value().at(0);
        const auto record = decode_world_definition(stored.settings).value();
        RecoveredWorld found = recover_world(*store, stored, record, {}).value();
        EXPECT_EQ(state_hash(found.world.world()), whole.hash);
        ASSERT_EQ(found.warnings.size(), 1u);
        EXPECT_NE(found.warnings[0].find("the checkpoint of tick"), std::string::npos);
    }
    Process process(folder / "worlds.db");
    EXPECT_EQ(process.worlds->find("yard")->frame()->tick, tick);
}

}  // namespace
}  // namespace jostle::server
