// SPDX-License-Identifier: MIT
//
// A persisted room that its owner rewinds: the earlier state is there after a reconnect, and after
// a restart of the server.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include "jostle/client/query_client.h"
#include "jostle/client/world_client.h"
#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;

class PersistedRoom : public testing::Test {
protected:
    PersistedRoom()
        : folder_(std::filesystem::temp_directory_path() /
                  ("jostle-rewind-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
        start();
        v1::CreateWorldRequest request;
        request.set_name("room");
        request.set_scene_name("stack");
        request.mutable_room()->set_timeline_seconds(60);
        const auto created = client::WorldClient(server->grpc_address()).create(request);
        EXPECT_TRUE(created.ok()) << created.error().message;
    }
    ~PersistedRoom() override { std::filesystem::remove_all(folder_); }

    void start() {
        server = std::make_unique<ServerProcess>(std::vector<std::string>{
            "--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0", "--set",
            "persistence.database=" + (folder_ / "worlds.db").string(), "--set",
            "persistence.checkpoint_interval_seconds=1"});
    }
    std::unique_ptr<Player> enter() {
        auto player = grpc_player(server->grpc_address());
        player->hello("room");
        EXPECT_TRUE(player->wait_until([](const PlayState& s) { return s.snapshots > 0; }))
            << player->end().value_or("no snapshot");
        return player;
    }
    static v1::InputResult act(Player& player, v1::Input input) {
        player.send_inputs({std::move(input)});
        const std::uint32_t sequence = player.inputs_sent().rbegin()->first;
        EXPECT_TRUE(
            player.wait_until([&](const PlayState& s) { return s.results.contains(sequence); }));
        return player.with_state([&](const PlayState& s) { return s.results.at(sequence); });
    }
    // Puts the box with this id to rest at x.
    static v1::Input move(std::uint32_t entity, double x) {
        v1::Input input;
        input.mutable_edit()->set_entity(entity);
        input.mutable_edit()->mutable_position()->set_x(x);
        input.mutable_edit()->mutable_position()->set_y(5);
        input.mutable_edit()->set_frozen(true);
        return input;
    }
    double x_of(std::uint32_t entity) const {
        client::QueryClient queries(server->grpc_address(), "room");
        const auto found = queries.inspect_entity(entity);
        return found.ok() ? found->value.position().x() : -1;
    }
    bool exists(std::uint32_t entity) const {
        return client::QueryClient(server->grpc_address(), "room").inspect_entity(entity).ok();
    }

    std::unique_ptr<ServerProcess> server;

private:
    std::filesystem::path folder_;
};

TEST_F(PersistedRoom, owner_finds_the_earlier_state_after_reconnect_and_restart) {
    constexpr std::uint32_t box = 3;
    auto owner = enter();
    const v1::InputResult moved = act(*owner, move(box, 40));
    ASSERT_EQ(moved.code(), v1::INPUT_CODE_APPLIED) << moved.message();
    std::uint32_t restorable = 0;
    ASSERT_TRUE(owner->wait_until([&](const PlayState& s) {
        restorable = s.restorable_ticks.empty() ? 0 : s.restorable_ticks.back();
        return restorable >= moved.tick();
    })) << "one state per second";
    const v1::InputResult later = act(*owner, move(box, 50));
    ASSERT_EQ(later.code(), v1::INPUT_CODE_APPLIED) << later.message();
    ASSERT_GT(later.tick(), restorable);
    const v1::InputResult spawned = act(*owner, spawn_box(6, 8, 0));
    ASSERT_EQ(spawned.code(), v1::INPUT_CODE_APPLIED) << spawned.message();
    EXPECT_EQ(x_of(box), 50);
    EXPECT_TRUE(exists(spawned.entity()));

    auto other = enter();
    v1::Input rewind;
    rewind.mutable_room()->mutable_rewind()->set_tick(restorable);
    EXPECT_EQ(act(*other, rewind).code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_EQ(x_of(box), 50);
    EXPECT_EQ(act(*owner, rewind).code(), v1::INPUT_CODE_APPLIED);
    ASSERT_TRUE(owner->wait_for_end()) << "clients reconnect after a rewind";
    ASSERT_TRUE(other->wait_for_end());
    EXPECT_TRUE(owner->with_state([](const PlayState& s) {
        return !s.notices.empty() && s.notices.back().code() == v1::NOTICE_CODE_WORLD_RESTARTED;
    }));

    owner = enter();
    EXPECT_EQ(x_of(box), 40);
    EXPECT_FALSE(exists(spawned.entity()));
    EXPECT_TRUE(owner->with_state([&](const PlayState& s) {
        return s.entities.contains(box) && !s.entities.contains(spawned.entity());
    }));
    const v1::InputResult next = act(*owner, spawn_box(6, 8, 0));
    ASSERT_EQ(next.code(), v1::INPUT_CODE_APPLIED) << next.message();
    EXPECT_GT(next.tick(), spawned.tick()) << "ticks are never reused";
    EXPECT_GT(next.entity(), spawned.entity()) << "nor are ids";

    server->signal(SIGTERM);
    ASSERT_EQ(server->wait(20s), 0) << server->log();
    start();
    ASSERT_TRUE(server->is_running()) << server->log();
    EXPECT_EQ(x_of(box), 40) << "the rewound state was persisted";
    EXPECT_FALSE(exists(spawned.entity()));
    owner = enter();
    EXPECT_FALSE(owner->with_state(
        [&](const PlayState& s) { return s.entities.contains(spawned.entity()); }));
    EXPECT_EQ(owner->with_state([](const PlayState& s) { return s.first_violation; }), "");
}

}  // namespace
}  // namespace jostle::test
