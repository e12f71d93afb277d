// SPDX-License-Identifier: MIT
#include "server/world/room.h"

#include <gtest/gtest.h>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using test::dt;
using test::error_of;

constexpr EntityId scene_box = 4;  // of the scene "stack"
constexpr ClientId actor = 1, other = 2, spectator = 3;

class RoomTest : public testing::Test {
protected:
    explicit RoomTest(RoomProperties properties = {}, const std::string& owner = "ada") {
        world.set_room(new_room(std::move(properties), owner));
        enter(actor, "subject/bob");
        enter(other, "subject/eve");
        enter(spectator, "subject/tim", true);
    }
    void enter(ClientId client, std::string member, bool watches = false) {
        const RoomCommand entry{EnterRoom{.member = std::move(member), .spectator = watches}};
        EXPECT_TRUE(world.apply({.client = client, .action = entry, .reply = {}}, 1).status.ok());
    }
    void set_role(ClientId client, PlayerRole role) {
        const Status done = world.apply_to_room({SetRole{client, role}});
        EXPECT_TRUE(done.ok());
    }
    InputResult apply(ClientId client, Action action) {
        return world.apply(
            {.client = client, .sequence = ++sequence, .action = std::move(action), .reply = {}},
            1);
    }
    template <class Kind>
    Status command(ClientId client, Kind kind) {
        return apply(client, RoomCommand{std::move(kind)}).status;
    }
    static SpawnCommand ball(double x = 5) {
        SpawnCommand spawn;
        spawn.shape.geometry = physics::Sphere{0.3};
        spawn.pose.position = {x, 20, 0};
        return spawn;
    }
    EntityId spawn(ClientId client, double x = 5) {
        const InputResult result = apply(client, ball(x));
        EXPECT_TRUE(result.status.ok()) << result.status.error().message;
        return result.entity;
    }
    void step(double seconds) {
        for (int k = 0; k < seconds / dt; k++) ASSERT_TRUE(world.step(dt).ok());
    }
    const RoomClient& member(ClientId client) { return *world.room()->state().find(client); }

    HostedWorld world = std::move(*HostedWorld::create(
        *scenes::find_scene("stack"), {.scene = {.bodies_max = 200}, .bodies_owned_max = 100}, 1));
    std::uint32_t sequence = 0;
};

// --- permissions ---

// Whether the table refuses; other errors come from behind it.
bool is_refused(const Status& status) {
    return !status.ok() && status.error().code == ErrorCode::permission_denied &&
           status.error().message.starts_with("room.permissions");
}

struct Cell {
    const char* action;
    const char* target;   // own, scene, other or none
    const char* allowed;  // spectator, player, builder, owner
};
constexpr Cell table[] = {
    {"spawn", "none", "nyyy"},         {"explode", "none", "nyyy"},
    {"push", "own", "nyyy"},           {"push", "scene", "nyyy"},
    {"push", "other", "nnyy"},         {"drag", "own", "nyyy"},
    {"drag", "scene", "nyyy"},         {"drag", "other", "nnyy"},
    {"delete", "own", "nyyy"},         {"delete", "scene", "nnyy"},
    {"delete", "other", "nnny"},       {"joints", "scene", "nyyy"},
    {"control", "own", "nyyy"},        {"control", "scene", "nyyy"},
    {"control", "other", "nyyy"},      {"message", "none", "yyyy"},
    {"vote", "other", "nyyy"},         {"clean_up", "own", "nyyy"},
    {"clean_up", "other", "nnny"},     {"mute", "other", "nnyy"},
    {"kick", "other", "nnny"},         {"ban", "other", "nnny"},
    {"set_role", "other", "nnny"},     {"protect", "none", "nnyy"},
    {"edit", "own", "nyyy"},           {"edit", "scene", "nnyy"},
    {"edit", "other", "nnny"},         {"clone", "own", "nyyy"},
    {"clone", "scene", "nyyy"},        {"clone", "other", "nnyy"},
    {"create_joint", "own", "nyyy"},   {"create_joint", "scene", "nyyy"},
    {"create_joint", "other", "nnyy"}, {"delete_joint", "own", "nyyy"},
    {"delete_joint", "scene", "nyyy"}, {"delete_joint", "other", "nnyy"},
    {"undo", "own", "nyyy"},           {"speed", "none", "nnyy"},
    {"rewind", "none", "nnny"},        {"step", "none", "nnyy"},
    {"pause", "none", "nnyy"},         {"reset", "none", "nnny"},
    {"settings", "none", "nnny"},
};

class RoomPermissions : public RoomTest,
                        public testing::WithParamInterface<std::tuple<Cell, std::size_t>> {
protected:
    Status act(const std::string& action, EntityId entity, const std::string& target) {
        const ClientId client = target == "own" ? actor : spectator;
        if (action == "spawn") return apply(actor, ball()).status;
        if (action == "explode")
            return apply(actor, ExplodeCommand{.center = {90, 0, 0}, .radius = 1, .speed = 1})
                .status;
        if (action == "push") return apply(actor, ImpulseCommand{entity, {1, 0, 0}, {}}).status;
        if (action == "drag") return apply(actor, GrabCommand{entity, {}}).status;
        if (action == "delete") return apply(actor, DeleteCommand{entity}).status;
        if (action == "joints") return apply(actor, CutCommand{}).status;
        if (action == "edit")
            return apply(actor, EditCommand{.entity = entity, .friction = 0.3}).status;
        if (action == "clone") return apply(actor, CloneCommand{entity, {0, 30, 0}}).status;
        if (action == "create_joint")
            return apply(actor, CreateJointCommand{0, entity, {}, {}}).status;
        if (action == "delete_joint") {
            const ClientId maker = target == "own" ? actor : target == "scene" ? 0 : other;
            const PlayerRole role = member(actor).role;
            set_role(other, PlayerRole::builder);
            set_role(actor, PlayerRole::builder);
            EXPECT_TRUE(apply(maker, CreateJointCommand{0, entity, {}, {}}).status.ok());
            set_role(actor, role);
            return apply(actor, DeleteJointCommand{.target = world.world().joints().back()}).status;
        }
        if (action == "undo") return apply(actor, UndoCommand{}).status;
        if (action == "speed") return command(actor, SetRoomSpeed{50});
        if (action == "rewind") return command(actor, RewindRoom{1});
        if (action == "step") return command(actor, StepRoom{1});
        if (action == "control") return apply(actor, PossessCommand{entity}).status;
        if (action == "message") return world.may_send_message(actor);
        if (action == "vote") return command(actor, VoteToKick{other});
        if (action == "clean_up") return command(actor, CleanUpBodies{client});
        if (action == "mute") return command(actor, MuteClient{client, 5});
        if (action == "kick") return command(actor, KickClient{client, {}});
        if (action == "ban") return command(actor, BanClient{client, 5, {}});
        if (action == "set_role") return command(actor, SetRole{client, PlayerRole::spectator});
        if (action == "protect") return command(actor, ProtectArea{{"x", {}, {1, 1, 1}}});
        if (action == "pause") return command(actor, PauseRoom{true});
        if (action == "reset") return command(actor, ResetRoom{});
        EXPECT_EQ(action, "settings");
        return command(actor, UpdateRoom{});
    }
};

TEST_P(RoomPermissions, allows_what_the_table_lists) {
    const auto& [cell, index] = GetParam();
    const std::string target = cell.target;
    const EntityId own = spawn(actor), foreign = spawn(other, 8);
    const auto role = static_cast<PlayerRole>(index + 1);
    set_role(actor, role);
    const EntityId entity = target == "own" ? own : target == "other" ? foreign : scene_box;
    const Status done = act(cell.action, entity, target);
    EXPECT_EQ(!is_refused(done), cell.allowed[index] == 'y')
        << name_of(role) << (done.ok() ? "" : ": " + done.error().message);
}

std::string name_of_case(const testing::TestParamInfo<std::tuple<Cell, std::size_t>>& at) {
    const auto& [cell, index] = at.param;
    return std::string(cell.action) + "_" + cell.target + "_" +
           std::string(name_of(static_cast<PlayerRole>(index + 1)));
}

INSTANTIATE_TEST_SUITE_P(Table, RoomPermissions,
                         testing::Combine(testing::ValuesIn(table),
                                          testing::Range<std::size_t>(0, 4)),
                         name_of_case);

TEST_F(RoomTest, refusal_names_the_rule) {
    const EntityId foreign = spawn(other);
    const Error error = error_of(apply(actor, ImpulseCommand{foreign, {1, 0, 0}, {}}).status);
    EXPECT_EQ(error.message,
              "room.permissions: player.push is unowned; the role player may not push an entity of "
              "another client");
}

TEST_F(RoomTest, client_that_has_not_entered_may_do_nothing) {
    EXPECT_EQ(error_of(apply(77, ball()).status).code, ErrorCode::permission_denied);
    EXPECT_TRUE(apply(77, LeaveCommand{}).status.ok());
}

struct RoomWithoutExplosions : RoomTest {
    static RoomProperties properties() {
        RoomProperties room;
        EXPECT_TRUE(set_permission(room, "player.explode", "none").ok());
        EXPECT_TRUE(set_permission(room, "player.delete", "any").ok());
        return room;
    }
    RoomWithoutExplosions() : RoomTest(properties()) {}
};

TEST_F(RoomWithoutExplosions, room_replaces_entries_of_the_table) {
    const EntityId foreign = spawn(other);
    EXPECT_TRUE(is_refused(apply(actor, ExplodeCommand{{}, 4, 6}).status));
    EXPECT_TRUE(apply(actor, DeleteCommand{foreign}).status.ok());
}

// --- quotas ---

struct RoomWithQuotas : RoomTest {
    static RoomProperties properties() {
        RoomProperties room;
        EXPECT_TRUE(set_quota(room, "player.bodies", 2).ok());
        EXPECT_TRUE(set_quota(room, "player.energy_per_second", 1000).ok());
        EXPECT_TRUE(set_quota(room, "player.explosions_per_minute", 12).ok());
        return room;
    }
    RoomWithQuotas() : RoomTest(properties()) {}
};

TEST_F(RoomWithQuotas, limits_bodies) {
    spawn(actor), spawn(actor, 8);
    const Error error = error_of(apply(actor, ball(11)).status);
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_EQ(error.message,
              "the client owns 2 bodies; room.quotas: player.bodies allows 2; delete a body first");
    spawn(other, 11);
}

// 12 per minute: two at once, then one every 5 s. An explosion of 1 m/s has 500 J.
TEST_F(RoomWithQuotas, explosions_are_refused_until_the_time_to_retry) {
    const auto explode = [&] {
        return apply(actor, ExplodeCommand{.center = {90, 0, 0}, .radius = 1, .speed = 1}).status;
    };
    EXPECT_TRUE(explode().ok());
    EXPECT_TRUE(explode().ok());
    const Error error = error_of(explode());
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_NEAR(error.retry_after_ms, 5000, 100);
    EXPECT_EQ(error.message, "room.quotas: player.explosions_per_minute is 12; retry in 5.0 s");
    step(error.retry_after_ms / 1000.0 - 0.2);
    EXPECT_FALSE(explode().ok());
    step(0.2);
    EXPECT_TRUE(explode().ok());
}

// An explosion of 20 m/s has 200 kJ, and the quota is 1000 J/s with a reserve of 2000 J.
TEST_F(RoomWithQuotas, energy_may_be_overdrawn_once) {
    EXPECT_TRUE(
        apply(actor, ExplodeCommand{.center = {90, 0, 0}, .radius = 1, .speed = 20}).status.ok());
    const Error error = error_of(apply(actor, ball()).status);
    EXPECT_TRUE(error.message.starts_with("room.quotas: player.energy_per_second is 1000"));
    EXPECT_NEAR(error.retry_after_ms, 198000, 100);
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(apply(actor, ball()).status.ok()) << "the owner has no quota";
}

// --- moderation ---

TEST_F(RoomTest, kicked_client_may_do_nothing_and_may_enter_again) {
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(command(actor, KickClient{other, "please be kind"}).ok());
    EXPECT_TRUE(member(other).removed);
    EXPECT_EQ(error_of(apply(other, ball()).status).message,
              "the client was removed from the room: please be kind");
    apply(other, LeaveCommand{});
    enter(4, "subject/eve");
    EXPECT_FALSE(member(4).removed);
}

TEST_F(RoomTest, ban_lasts_for_its_time) {
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(command(actor, BanClient{other, 2, "spamming"}).ok());
    enter(4, "subject/eve");
    EXPECT_TRUE(member(4).removed);
    apply(4, LeaveCommand{});
    step(2.1);
    enter(5, "subject/eve");
    EXPECT_FALSE(member(5).removed);
    EXPECT_TRUE(world.room()->state().bans.empty());
}

TEST_F(RoomTest, muted_client_retries_later) {
    set_role(actor, PlayerRole::builder);
    EXPECT_TRUE(command(actor, MuteClient{other, 3}).ok());
    step(1);
    const Error error = error_of(world.may_send_message(other));
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_NEAR(error.retry_after_ms, 2000, 50);
    EXPECT_TRUE(world.may_send_message(actor).ok());
    step(2.1);
    EXPECT_TRUE(world.may_send_message(other).ok());
}

TEST_F(RoomTest, clean_up_deletes_all_bodies_of_a_client) {
    spawn(other), spawn(other, 8);
    const EntityId mine = spawn(actor, 11);
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(command(actor, CleanUpBodies{other}).ok());
    EXPECT_EQ(world.ownership().count(other), 0);
    EXPECT_TRUE(world.ownership().owns(actor, mine));
}

TEST_F(RoomTest, protected_area_admits_its_role_only) {
    set_role(actor, PlayerRole::builder);
    const ProtectedArea tower{"tower", {-3, -3, -3}, {3, 30, 3}};
    EXPECT_TRUE(command(actor, ProtectArea{tower}).ok());
    EXPECT_EQ(error_of(apply(other, ImpulseCommand{scene_box, {1, 0, 0}, {}}).status).message,
              "the area \"tower\" is protected: it requires the role builder, and the client has "
              "the role player");
    EXPECT_FALSE(apply(other, ball(2)).status.ok());
    EXPECT_TRUE(apply(other, ball(8)).status.ok());
    // 4 m from the area.
    EXPECT_FALSE(
        apply(other, ExplodeCommand{.center = {7, 5, 0}, .radius = 5, .speed = 1}).status.ok());
    EXPECT_TRUE(
        apply(other, ExplodeCommand{.center = {7, 5, 0}, .radius = 3, .speed = 1}).status.ok());
    EXPECT_TRUE(apply(actor, ImpulseCommand{scene_box, {1, 0, 0}, {}}).status.ok());
    EXPECT_TRUE(command(actor, UnprotectArea{"tower"}).ok());
    EXPECT_TRUE(apply(other, ImpulseCommand{scene_box, {1, 0, 0}, {}}).status.ok());
}

TEST_F(RoomTest, no_client_moderates_an_equal_or_higher_role) {
    set_role(actor, PlayerRole::builder);
    set_role(other, PlayerRole::builder);
    EXPECT_EQ(error_of(command(actor, MuteClient{other, 5})).message,
              "client 2 has the role builder; the role builder may not mute it");
    EXPECT_EQ(error_of(command(actor, KickClient{99, {}})).code, ErrorCode::permission_denied);
    set_role(actor, PlayerRole::owner);
    EXPECT_EQ(error_of(command(actor, KickClient{99, {}})).code, ErrorCode::not_found);
}

// Two of three other players are more than half; spectators do not vote.
TEST_F(RoomTest, vote_of_most_players_kicks) {
    enter(4, "subject/kim");
    enter(5, "subject/joe");
    EXPECT_TRUE(command(actor, VoteToKick{other}).ok());
    EXPECT_TRUE(command(actor, VoteToKick{other}).ok()) << "counts once";
    EXPECT_FALSE(member(other).removed);
    EXPECT_EQ(error_of(command(4, VoteToKick{5})).code, ErrorCode::resource_exhausted)
        << "one vote at a time";
    EXPECT_TRUE(is_refused(command(spectator, VoteToKick{other})));
    EXPECT_TRUE(command(4, VoteToKick{other}).ok());
    EXPECT_TRUE(member(other).removed);
    enter(6, "subject/eve");
    EXPECT_TRUE(member(6).removed) << "banned for 300 s";
    const Error again = error_of(command(actor, VoteToKick{5}));
    EXPECT_EQ(again.code, ErrorCode::resource_exhausted);
    EXPECT_EQ(again.retry_after_ms, 120000);
}

// --- roles ---

TEST_F(RoomTest, new_settings_apply_at_once) {
    RoomProperties closed{.title = "Closed"};
    ASSERT_TRUE(set_permission(closed, "player.spawn", "none").ok());
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(command(actor, UpdateRoom{std::make_shared<const RoomProperties>(closed)}).ok());
    EXPECT_EQ(world.room()->state().properties, closed);
    EXPECT_FALSE(apply(other, ball()).status.ok());
    EXPECT_EQ(member(actor).role, PlayerRole::owner);
}

TEST_F(RoomTest, owner_transfers_the_room) {
    enter(4, "subject/ada");
    EXPECT_EQ(member(4).role, PlayerRole::owner);
    EXPECT_TRUE(command(4, SetRole{actor, PlayerRole::owner}).ok());
    EXPECT_EQ(member(4).role, PlayerRole::builder);
    EXPECT_EQ(world.room()->state().owner, "subject/bob");
    apply(actor, LeaveCommand{});
    enter(5, "subject/bob");
    EXPECT_EQ(member(5).role, PlayerRole::owner);
    enter(6, "subject/ada");
    EXPECT_EQ(member(6).role, PlayerRole::builder);
}

TEST_F(RoomTest, player_list_has_the_roles_of_the_room) {
    for (const ClientId client : {actor, other})
        world.apply({.client = client, .action = JoinCommand{.name = "ann"}, .reply = {}}, 1);
    set_role(actor, PlayerRole::builder);
    EXPECT_EQ(world.players().role_of(actor), PlayerRole::builder);
    EXPECT_TRUE(world.apply_as_server(SetRoleCommand{other, PlayerRole::owner}).ok());
    EXPECT_EQ(member(other).role, PlayerRole::owner);
    EXPECT_EQ(world.players().role_of(other), PlayerRole::owner);
    apply(actor, LeaveCommand{});
    enter(4, "subject/bob");
    world.apply({.client = 4, .action = JoinCommand{.name = "bob"}, .reply = {}}, 1);
    EXPECT_EQ(world.players().role_of(4), PlayerRole::builder) << "the role of its subject";
}

TEST_F(RoomTest, muted_client_sends_messages_to_the_server_only) {
    set_role(actor, PlayerRole::owner);
    EXPECT_TRUE(command(actor, MuteClient{other, 3}).ok());
    const SendMessageCommand chat{.topic = "chat", .data = "hello"};
    EXPECT_EQ(error_of(apply(other, chat).status).code, ErrorCode::resource_exhausted);
    EXPECT_TRUE(
        apply(other, SendMessageCommand{.topic = "chat", .data = "hello", .to_server = true})
            .status.ok());
    EXPECT_TRUE(apply(actor, chat).status.ok());
}

TEST_F(RoomTest, role_persists_for_a_subject) {
    set_role(other, PlayerRole::builder);
    apply(other, LeaveCommand{});
    enter(4, "subject/eve");
    EXPECT_EQ(member(4).role, PlayerRole::builder);
}

struct RoomWithoutOwner : RoomTest {
    RoomWithoutOwner() : RoomTest({}, "") {}
};

TEST_F(RoomWithoutOwner, player_that_is_present_for_longest_is_the_owner) {
    EXPECT_EQ(member(actor).role, PlayerRole::owner);
    EXPECT_EQ(member(other).role, PlayerRole::player);
    apply(actor, LeaveCommand{});
    EXPECT_EQ(member(other).role, PlayerRole::owner);
    EXPECT_EQ(member(spectator).role, PlayerRole::spectator);
}

// --- state ---

std::string state_of(const HostedWorld& world) {
    return std::to_string(physics::state_hash(world.world())) +
           encode_host_state(world.host_state(9));
}

TEST_F(RoomWithQuotas, replay_of_the_commands_gives_the_same_state) {
    world.enable_journal();
    HostedWorld copy = std::move(*HostedWorld::create(
        *scenes::find_scene("stack"), {.scene = {.bodies_max = 200}, .bodies_owned_max = 100}, 1));
    copy.set_room(world.room()->state());
    const auto replay_tick = [&] {
        for (const JournaledCommand& one : world.take_journal()) copy.replay(one);
        ASSERT_TRUE(world.step(dt).ok());
        ASSERT_TRUE(copy.step(dt).ok());
    };
    for (int tick = 0; tick < 200; tick++) {
        apply(actor, ball(5 + tick % 7));
        apply(other, ExplodeCommand{.center = {2, 1, 0}, .radius = 4, .speed = 3});
        apply(actor, ImpulseCommand{scene_box, {900, 0, 0}, {}});
        if (tick == 40) static_cast<void>(command(other, VoteToKick{actor}));
        if (tick == 60) set_role(other, PlayerRole::owner);
        if (tick == 80) static_cast<void>(command(other, BanClient{actor, 1, "enough"}));
        if (tick == 90) static_cast<void>(command(other, CleanUpBodies{actor}));
        if (tick == 120) enter(7, "subject/kim");
        replay_tick();
    }
    EXPECT_EQ(state_of(copy), state_of(world));
    EXPECT_TRUE(world.room()->state().find(7));
}

TEST_F(RoomTest, restored_room_continues) {
    spawn(actor);
    set_role(other, PlayerRole::builder);
    EXPECT_TRUE(command(other, MuteClient{actor, 60}).ok());
    const SavedHostState saved = *decode_host_state(encode_host_state(world.host_state(1)));
    physics::World bodies = std::move(*physics::load(physics::save(world.world())));
    const HostedWorld restored =
        std::move(*HostedWorld::restore(std::move(bodies), saved, {}, 60, 0));
    ASSERT_NE(restored.room(), nullptr);
    EXPECT_EQ(restored.room()->state(), world.room()->state());
    EXPECT_FALSE(restored.may_send_message(actor).ok());
    EXPECT_TRUE(clients_of(saved).contains(spectator)) << "also without inputs";
}

TEST(World, without_a_room_restricts_nothing) {
    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    EXPECT_TRUE(world.may_send_message(1).ok());
    EXPECT_EQ(world.host_state(1).room, std::nullopt);
    EXPECT_EQ(encode_host_state(world.host_state(1))[0], 1) << "the version without rooms";
    const InputResult result = world.apply(
        {.client = 1, .sequence = 1, .action = RoomCommand{ResetRoom{}}, .reply = {}}, 1);
    EXPECT_EQ(error_of(result.status).code, ErrorCode::permission_denied);
    Frame frame;
    world.copy_into(frame);
    EXPECT_EQ(frame.room, nullptr);
}

}  // namespace
}  // namespace jostle::server
