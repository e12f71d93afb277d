// SPDX-License-Identifier: MIT
//
// Inputs about players, attributes and messages in a hosted world: permissions, journal and saved
// state.
#include <gtest/gtest.h>

#include "jostle/physics/restore_point.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using test::dt;
using test::error_of;

class WorldDataInputs : public testing::Test {
protected:
    static HostedWorld make() {
        return std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    }
    void join(ClientId client, PlayerRole role) {
        ASSERT_TRUE(
            apply(client,
                  JoinCommand{.name = "p" + std::to_string(client), .role = role, .tick = 1})
                .ok());
    }
    Status apply(ClientId client, Action action) {
        const std::uint32_t sequence = is_session_command(action) ? 0 : ++sequences[client];
        return world
            .apply(
                {.client = client, .sequence = sequence, .action = std::move(action), .reply = {}},
                tick)
            .status;
    }
    EntityId spawn(ClientId client) {
        SpawnCommand ball;
        ball.shape.geometry = physics::Sphere{0.3};
        ball.pose.position = {0, 20.0 + client, 5};
        return world
            .apply({.client = client, .sequence = ++sequences[client], .action = ball, .reply = {}},
                   tick)
            .entity;
    }
    ErrorCode code(ClientId client, const AttributeTarget& target, const char* key) {
        const Status status = apply(client, SetAttributesCommand{target, {{key, std::int64_t{1}}}});
        return status.ok() ? ErrorCode::internal : status.error().code;
    }

    HostedWorld world = make();
    std::map<ClientId, std::uint32_t> sequences;
    std::uint32_t tick = 1;
};

constexpr ClientId spectator = 1, player = 2, builder = 3, owner = 4;
constexpr ErrorCode allowed = ErrorCode::internal, denied = ErrorCode::permission_denied;

TEST_F(WorldDataInputs, roles_decide_whose_attributes_a_client_sets) {
    join(spectator, PlayerRole::spectator);
    join(player, PlayerRole::player);
    join(builder, PlayerRole::builder);
    join(owner, PlayerRole::owner);
    const EntityId balls[] = {spawn(player), spawn(builder)};
    struct Row {
        ClientId client;
        ErrorCode own_player, other_player, own_entity, other_entity, scene_entity, world;
    };
    const Row rows[] = {{spectator, allowed, denied, denied, denied, denied, denied},
                        {player, allowed, denied, allowed, denied, denied, denied},
                        {builder, allowed, denied, allowed, allowed, allowed, denied},
                        {owner, allowed, allowed, allowed, allowed, allowed, allowed}};
    for (const Row& row : rows) {
        const auto of = [&](AttributeTargetKind kind, std::uint32_t id) {
            return code(row.client, {kind, id}, "x");
        };
        constexpr auto of_player = AttributeTargetKind::player,
                       of_entity = AttributeTargetKind::entity,
                       of_world = AttributeTargetKind::world;
        const ClientId other = row.client == player ? builder : player;
        const EntityId own_ball = balls[row.client == builder ? 1 : 0],
                       other_ball = balls[row.client == builder ? 0 : 1];
        EXPECT_EQ(of(of_player, row.client), row.own_player) << row.client;
        EXPECT_EQ(of(of_player, other), row.other_player) << row.client;
        EXPECT_EQ(of(of_entity, own_ball), row.own_entity) << row.client;
        EXPECT_EQ(of(of_entity, other_ball), row.other_entity) << row.client;
        EXPECT_EQ(of(of_entity, 1), row.scene_entity) << row.client;
        EXPECT_EQ(of(of_world, 0), row.world) << row.client;
    }
    EXPECT_EQ(code(owner, {AttributeTargetKind::player, 99}, "x"), ErrorCode::not_found);
    EXPECT_EQ(code(owner, {AttributeTargetKind::entity, 9999}, "x"), ErrorCode::not_found);
    EXPECT_EQ(error_of(apply(builder, SetRoleCommand{builder, PlayerRole::owner})).code, denied);
    EXPECT_TRUE(apply(owner, SetRoleCommand{builder, PlayerRole::owner}).ok());
    EXPECT_EQ(code(builder, {}, "y"), allowed);
}

TEST_F(WorldDataInputs, attributes_end_with_their_entity_and_player) {
    join(player, PlayerRole::player);
    const EntityId ball = spawn(player);
    ASSERT_EQ(code(player, {AttributeTargetKind::entity, ball}, "x"), allowed);
    ASSERT_EQ(code(player, {AttributeTargetKind::player, player}, "x"), allowed);
    ASSERT_TRUE(apply(player, DeleteCommand{ball}).ok());
    EXPECT_EQ(world.attributes().size(), 1u);
    ASSERT_TRUE(apply(player, LeaveCommand{}).ok());
    EXPECT_TRUE(world.attributes().empty());
    EXPECT_EQ(world.players().size(), 0u);
}

TEST_F(WorldDataInputs, messages_are_for_players_that_exist) {
    join(player, PlayerRole::player);
    EXPECT_TRUE(apply(player, SendMessageCommand{"chat", "hello"}).ok());
    EXPECT_EQ(error_of(apply(player, SendMessageCommand{"chat", "psst", {player, 77}})).message,
              "player 77 does not exist");
    EXPECT_TRUE(apply(player, SendMessageCommand{"game", "ready", {}, true}).ok());
    Frame frame;
    frame.tick = 2;
    world.copy_into(frame);
    ASSERT_EQ(frame.messages->messages.size(), 2u);
    EXPECT_TRUE(frame.has_new_data);
    EXPECT_EQ(frame.messages->messages[0]->from, player);
    EXPECT_TRUE(frame.messages->messages[1]->to_server);
    EXPECT_EQ(world.messages()->count, 2u) << "the server reads them here";
    frame.tick = 3;
    world.copy_into(frame);
    EXPECT_FALSE(frame.has_new_data);
}

TEST_F(WorldDataInputs, the_journal_and_the_saved_state_reproduce_them) {
    world.enable_journal();
    join(player, PlayerRole::player);
    join(owner, PlayerRole::owner);
    const EntityId ball = spawn(player);
    code(player, {AttributeTargetKind::entity, ball}, "hp");
    code(owner, {}, "round");
    ASSERT_TRUE(apply(player, RenameCommand{"new name"}).ok());
    ASSERT_TRUE(apply(player, SendMessageCommand{"chat", "hello"}).ok());
    ASSERT_TRUE(world.apply_as_server(SetRoleCommand{player, PlayerRole::builder}).ok());
    ASSERT_TRUE(world
                    .apply_as_server(SetAttributesCommand{{AttributeTargetKind::player, player},
                                                          {{"score", 2.5}}})
                    .ok());
    ASSERT_TRUE(apply(owner, DisconnectCommand{}).ok());
    const std::vector<JournaledCommand> journal = world.take_journal();
    ASSERT_TRUE(world.step(dt, 1).ok());

    HostedWorld replayed = make();
    for (const JournaledCommand& command : journal) replayed.replay(command);
    ASSERT_TRUE(replayed.step(dt, 1).ok());
    EXPECT_EQ(replayed.data_hash(), world.data_hash());
    EXPECT_EQ(encode_host_state(replayed.host_state(1)), encode_host_state(world.host_state(1)));
    EXPECT_EQ(replayed.players().find(player)->name, "new name");

    physics::RestorePoint point;
    point.capture(world.world());
    physics::World bodies = std::move(*physics::World::create({}));
    point.restore(bodies).expect();
    const SavedHostState saved = *decode_host_state(encode_host_state(world.host_state(1)));
    const Result<HostedWorld> restored = HostedWorld::restore(std::move(bodies), saved, {}, 60, 0);
    ASSERT_TRUE(restored.ok()) << restored.error().message;
    EXPECT_EQ(restored->data_hash(), world.data_hash());
    EXPECT_FALSE(restored->players().find(owner)->connected);
    EXPECT_EQ(restored->message_count(), 1u);
    EXPECT_NE(make().data_hash(), world.data_hash());
}

TEST_F(WorldDataInputs, a_world_without_them_is_saved_as_before) {
    EXPECT_EQ(encode_host_state(world.host_state(1))[0], 1);
    join(player, PlayerRole::player);
    EXPECT_EQ(encode_host_state(world.host_state(1))[0], 2);
    ASSERT_TRUE(apply(player, LeaveCommand{}).ok());
    EXPECT_EQ(encode_host_state(world.host_state(1))[0], 1);
}

}  // namespace
}  // namespace jostle::server
