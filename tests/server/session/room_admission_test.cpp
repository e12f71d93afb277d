// SPDX-License-Identifier: MIT
#include "server/session/room_admission.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "server/session/empty_rooms.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;
using test::SessionHarness;

const Identity owner_of_room{.subject = "ada", .role = Role::director, .anonymous = false};
const Identity player_of_room{.subject = "bob", .role = Role::player, .anonymous = false};
const Identity anonymous_guest{.role = Role::player};
constexpr const char* guest_address = "192.0.2.7";

class RoomAdmissionTest : public testing::Test {
protected:
    std::shared_ptr<WorldHost> room(RoomProperties properties) {
        return server.worlds
            .create("room", *scenes::find_scene("stack"), "ada", std::move(properties))
            .value();
    }
    void command(WorldHost& world, RoomCommand command) {
        world.mailbox().push(
            {.client = 1, .sequence = ++sequence, .action = std::move(command), .reply = nullptr});
        world.tick(server.now);
    }

    test::TestServer server;
    std::uint32_t sequence = 100;
};

TEST_F(RoomAdmissionTest, private_room_requires_its_join_code) {
    const auto world = room({.join_code = "sesame"});
    const auto access = [&](const Identity& who, const char* code, bool has_ticket = false) {
        return check_room_access(*world, who, guest_address, code, has_ticket);
    };
    EXPECT_EQ(error_of(access(player_of_room, "")).message,
              "join_code: the room \"room\" is private, and the join code is missing");
    EXPECT_EQ(error_of(access(player_of_room, "open")).code, ErrorCode::permission_denied);
    EXPECT_TRUE(access(player_of_room, "sesame").ok());
    EXPECT_TRUE(access(player_of_room, "", true).ok());
    EXPECT_TRUE(access(owner_of_room, "").ok()) << "the owner";
    EXPECT_TRUE(access({.subject = "op", .role = Role::admin, .anonymous = false}, "").ok());
    EXPECT_FALSE(access({.role = Role::admin}, "").ok()) << "of a server without keys";
}

TEST_F(RoomAdmissionTest, client_with_the_code_joins_as_a_player) {
    const auto world = room({.join_code = "sesame"});
    SessionHarness refused(server, {.world = "room"}),
        admitted(server, {.world = "room", .join_code = "sesame"});
    play(server, *world, {&refused, &admitted}, 5);
    ASSERT_TRUE(refused.session->end());
    EXPECT_EQ(refused.session->end()->error().code, ErrorCode::permission_denied);
    EXPECT_FALSE(admitted.session->end());
    const RoomView view = world->frame()->room;
    ASSERT_EQ(view->clients.size(), 1u);
    EXPECT_EQ(view->clients[0].role, PlayerRole::player);
    EXPECT_EQ(view->clients[0].member, "network/127.0.0.1");
}

TEST_F(RoomAdmissionTest, full_room_refuses_further_clients) {
    const auto world = room({.capacity = 1});
    SessionHarness first(server, {.world = "room"}), second(server, {.world = "room"});
    play(server, *world, {&first, &second}, 5);
    EXPECT_FALSE(first.session->end());
    ASSERT_TRUE(second.session->end());
    EXPECT_EQ(second.session->end()->error().message, "the room \"room\" is full: 1 clients");
    EXPECT_TRUE(check_room_capacity(*world, server.sessions, owner_of_room, guest_address).ok())
        << "the owner";
    EXPECT_EQ(error_of(server.sessions.enter(world->id(), "elsewhere", {}, 1)).code,
              ErrorCode::resource_exhausted);
}

TEST_F(RoomAdmissionTest, ban_ends_the_session_and_refuses_the_next_one) {
    const auto world = room({});
    world->mailbox().enter(1, {.member = "subject/ada"});
    world->mailbox().enter(2, {.member = member_of(anonymous_guest, guest_address)});
    world->tick(server.now);
    command(*world, {BanClient{2, 60, "spamming"}});
    EXPECT_EQ(
        error_of(check_room_access(*world, anonymous_guest, guest_address, {}, false)).message,
        "the room \"room\" has banned the caller: spamming");
    EXPECT_TRUE(check_room_access(*world, anonymous_guest, "192.0.2.8", {}, false).ok());
}

TEST_F(RoomAdmissionTest, kicked_client_receives_the_reason) {
    const auto world = room({});
    SessionHarness client(server, {.world = "room"});
    play(server, *world, {&client}, 5);
    const ClientId id = client.conversation.stats().client_id;
    world->mailbox().enter(99, {.member = "subject/ada"});
    world->mailbox().push({.client = 99,
                           .sequence = 1,
                           .action = RoomCommand{KickClient{id, "please be kind"}},
                           .reply = nullptr});
    play(server, *world, {&client}, 3);
    ASSERT_TRUE(client.session->end());
    EXPECT_EQ(client.session->end()->error().message,
              "the client was removed from the room: please be kind");
    play(server, *world, {}, 1);
    EXPECT_EQ(world->frame()->room->find(id), nullptr) << "it has left";
}

TEST_F(RoomAdmissionTest, room_inputs_return_results_to_the_client) {
    const auto world = room({});
    SessionHarness client(server, {.world = "room"});
    play(server, *world, {&client}, 5);
    v1::Input input;
    input.mutable_room()->mutable_kick()->set_client(42);
    client.conversation.send(input);
    input.mutable_room()->mutable_mute()->set_seconds(-1);
    client.conversation.send(input);
    play(server, *world, {&client}, 10);
    const std::vector<v1::InputResult> results = client.conversation.take_results();
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results[0].code(), v1::INPUT_CODE_INVALID);
    EXPECT_EQ(results[0].message(), "mute.seconds is -1; it must be from 0 to 315360000");
    EXPECT_EQ(results[1].code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_EQ(results[1].message(),
              "room.permissions: player.kick is none; the role player may not kick");
}

TEST_F(RoomAdmissionTest, members_pause_and_resume_but_not_what_an_operator_paused) {
    const auto world = room({});
    world->mailbox().enter(1, {.member = "subject/ada"});
    command(*world, {PauseRoom{true}});
    EXPECT_EQ(world->lifecycle().paused(), "by a member of the room");
    command(*world, {PauseRoom{false}});
    EXPECT_FALSE(world->lifecycle().paused());
    world->pause("for maintenance");
    command(*world, {PauseRoom{false}});
    EXPECT_EQ(world->lifecycle().paused(), "for maintenance");
}

TEST_F(RoomAdmissionTest, reset_starts_the_scene_again_and_clients_resume) {
    const auto world = room({});
    SessionHarness client(server, {.world = "room"});
    world->mailbox().enter(99, {.member = "subject/ada"});
    play(server, *world, {&client}, 5);
    const ClientId id = client.conversation.stats().client_id;
    const std::uint32_t tick = world->frame()->tick;
    world->mailbox().push(
        {.client = 99, .sequence = 500, .action = RoomCommand{ResetRoom{}}, .reply = nullptr});
    play(server, *world, {&client}, 1);
    server.worlds.reset_requested();
    const auto fresh = server.worlds.find("room");
    ASSERT_NE(fresh, world);
    EXPECT_GT(fresh->frame()->tick, tick);
    EXPECT_TRUE(fresh->frame()->room->find(id)) << "the room retains its members";
    play(server, *fresh, {&client}, 2);
    ASSERT_TRUE(client.session->end());
    client.conversation.ended(*client.session->end());
    client.connect();
    play(server, *fresh, {&client}, 5);
    EXPECT_FALSE(client.session->end());
    EXPECT_EQ(client.conversation.stats().client_id, id);
}

TEST_F(RoomAdmissionTest, empty_room_is_closed_after_ten_seconds) {
    const auto world = room({.close_when_empty = true});
    EmptyRooms rooms;
    {
        SessionHarness client(server, {.world = "room"});
        play(server, *world, {&client}, 5);
        rooms.close(server.context, server.now);
        client.conversation.leave();
        play(server, *world, {&client}, 5);
    }
    rooms.close(server.context, server.now);
    rooms.close(server.context, server.now + 9s);
    EXPECT_TRUE(server.worlds.find("room"));
    rooms.close(server.context, server.now + 11s);
    EXPECT_FALSE(server.worlds.find("room"));
}

}  // namespace
}  // namespace jostle::server
