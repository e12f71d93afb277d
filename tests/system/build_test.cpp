// SPDX-License-Identifier: MIT
//
// Building end to end: clients over both transports edit, clone and join bodies, undo, and rewind a
// room.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "jostle/client/query_client.h"
#include "jostle/client/world_client.h"
#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;

class Build : public testing::Test {
protected:
    Build() {
        v1::CreateWorldRequest request;
        request.set_name("room");
        request.set_scene_name("stack");
        request.mutable_room()->set_timeline_seconds(60);
        request.mutable_room()->set_initial_role("builder");
        const auto created = client::WorldClient(server.grpc_address()).create(request);
        EXPECT_TRUE(created.ok()) << created.error().message;
        players.push_back(grpc_player(server.grpc_address()));
        players.push_back(websocket_player(server.http_port()));
        for (const auto& player : players) {
            player->hello("room");
            EXPECT_TRUE(player->wait_until([](const PlayState& s) { return s.snapshots > 0; }))
                << player->end().value_or("no snapshot");
        }
    }
    v1::InputResult act(Player& player, v1::Input input) {
        player.send_inputs({std::move(input)});
        const std::uint32_t sequence = player.inputs_sent().rbegin()->first;
        EXPECT_TRUE(
            player.wait_until([&](const PlayState& s) { return s.results.contains(sequence); }));
        return player.with_state([&](const PlayState& s) { return s.results.at(sequence); });
    }
    bool sees(Player& player, std::uint32_t entity,
              const std::function<bool(const v1::Entity&)>& condition) {
        return player.wait_until([&](const PlayState& s) {
            const auto at = s.entities.find(entity);
            return at != s.entities.end() && condition(at->second);
        });
    }

    ServerProcess server{{"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"}};
    std::vector<std::unique_ptr<Player>> players;
};

TEST_F(Build, clients_of_both_transports_edit_join_clone_and_undo) {
    client::QueryClient queries(server.grpc_address(), "room");
    for (std::size_t at = 0; at < players.size(); at++) {
        Player &player = *players[at], &watcher = *players[1 - at];
        const v1::InputResult spawned = act(player, spawn_box(6, 8, 0));
        ASSERT_EQ(spawned.code(), v1::INPUT_CODE_APPLIED) << spawned.message();
        const std::uint32_t box = spawned.entity();

        v1::Input edit;
        edit.mutable_edit()->set_entity(box);
        edit.mutable_edit()->set_mass(30);
        edit.mutable_edit()->set_color(0x336699);
        edit.mutable_edit()->set_frozen(false);
        ASSERT_EQ(act(player, edit).code(), v1::INPUT_CODE_APPLIED);
        EXPECT_TRUE(sees(watcher, box, [](const v1::Entity& entity) {
            return entity.color() == 0x336699 && entity.mass() > 29.9 && entity.mass() < 30.1;
        }));

        v1::Input join;
        join.mutable_create_joint()->set_entity_b(box);
        join.mutable_create_joint()->mutable_joint()->mutable_frame_a()->mutable_position()->set_x(
            6);
        join.mutable_create_joint()->mutable_joint()->mutable_frame_a()->mutable_position()->set_y(
            8);
        join.mutable_create_joint()->mutable_joint()->mutable_ball();
        const v1::InputResult joined = act(player, join);
        ASSERT_EQ(joined.code(), v1::INPUT_CODE_APPLIED) << joined.message();
        ASSERT_GT(joined.joint(), 0u);
        const auto joint = queries.inspect_joint(joined.joint());
        ASSERT_TRUE(joint.ok()) << joint.error().message;
        EXPECT_EQ(joint->value.entity_b(), box);
        EXPECT_NE(joint->value.owner(), 0u);
        EXPECT_EQ(queries.inspect_entity(box)->value.joint_count(), 1u);

        v1::Input clone;
        clone.mutable_clone()->set_entity(box);
        clone.mutable_clone()->mutable_offset()->set_y(3);
        const v1::InputResult cloned = act(player, clone);
        ASSERT_EQ(cloned.code(), v1::INPUT_CODE_APPLIED) << cloned.message();
        EXPECT_TRUE(sees(watcher, cloned.entity(),
                         [](const v1::Entity& entity) { return entity.color() == 0x336699; }));

        v1::Input cut;
        cut.mutable_delete_joint()->set_joint(joined.joint());
        EXPECT_EQ(act(player, cut).code(), v1::INPUT_CODE_APPLIED);
        EXPECT_EQ(act(player, cut).code(), v1::INPUT_CODE_NOT_FOUND);
        v1::Input undo;
        undo.mutable_undo();
        for (int k = 0; k < 5; k++)
            EXPECT_EQ(act(player, undo).code(), v1::INPUT_CODE_APPLIED) << k;
        const v1::InputResult nothing = act(player, undo);
        EXPECT_EQ(nothing.code(), v1::INPUT_CODE_NOT_FOUND);
        EXPECT_EQ(nothing.message(), "the client has no action to undo");
        EXPECT_TRUE(watcher.wait_until([&](const PlayState& s) {
            return !s.entities.contains(box) && !s.entities.contains(cloned.entity());
        }));
    }
    for (const auto& player : players)
        EXPECT_EQ(player->with_state([](const PlayState& s) { return s.first_violation; }), "");
}

TEST_F(Build, room_without_a_database_rewinds_for_its_owner) {
    Player &owner = *players[0], &other = *players[1];
    // The first state may already contain this box, but not the next one.
    ASSERT_EQ(act(owner, spawn_box(9, 8, 0)).code(), v1::INPUT_CODE_APPLIED);
    v1::Input rewind;
    rewind.mutable_room()->mutable_rewind()->set_tick(
        owner.with_state([](const PlayState& s) { return s.welcome.tick(); }) + 1000000);
    const v1::InputResult unknown = act(owner, rewind);
    EXPECT_EQ(unknown.code(), v1::INPUT_CODE_NOT_FOUND);
    ASSERT_NE(unknown.message().find(" states from tick "), std::string::npos) << unknown.message();
    const std::size_t from = unknown.message().find("from tick ") + 10;
    const auto first = static_cast<std::uint32_t>(std::stoul(unknown.message().substr(from)));
    const v1::InputResult spawned = act(owner, spawn_box(6, 8, 0));
    ASSERT_EQ(spawned.code(), v1::INPUT_CODE_APPLIED) << spawned.message();
    ASSERT_GT(spawned.tick(), first);
    rewind.mutable_room()->mutable_rewind()->set_tick(first);
    const v1::InputResult refused = act(other, rewind);
    EXPECT_EQ(refused.code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_EQ(refused.message(),
              "room.permissions: builder.rewind is none; the role builder may not rewind");
    EXPECT_EQ(act(owner, rewind).code(), v1::INPUT_CODE_APPLIED);
    EXPECT_TRUE(owner.wait_for_end()) << "clients reconnect after a rewind";
    const auto again = grpc_player(server.grpc_address());
    again->hello("room");
    ASSERT_TRUE(again->wait_until([](const PlayState& s) { return s.snapshots > 0; }));
    EXPECT_FALSE(again->with_state(
        [&](const PlayState& s) { return s.entities.contains(spawned.entity()); }));
}

}  // namespace
}  // namespace jostle::test
