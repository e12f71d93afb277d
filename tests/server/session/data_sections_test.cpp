// SPDX-License-Identifier: MIT
//
// Players, attributes and user messages from clients through a hosted world to other clients.
#include "server/session/data_sections.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/client/world_data.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using client::attributes_input;
using client::AttributeTarget;
using client::message_input;
using test::SessionHarness;
using test::TestServer;

v1::Attribute attribute(const char* key, std::int64_t value,
                        v1::AttributeVisibility visibility = v1::ATTRIBUTE_VISIBILITY_EVERYONE,
                        std::uint32_t roles = 0) {
    v1::Attribute attribute;
    attribute.set_key(key);
    attribute.set_integer(value);
    attribute.set_visibility(visibility);
    attribute.set_roles(roles);
    return attribute;
}

// -1: the client does not have the attribute.
std::int64_t value(const SessionHarness& of, const AttributeTarget& target, const char* key) {
    const v1::Attribute* const found = of.conversation.view().data().attribute(target, key);
    return found ? found->integer() : -1;
}

client::ClientOptions options(const char* name) {
    return {.name = name, .players = true, .attributes = true, .topics = {"*"}};
}

class DataSectionsTest : public testing::Test {
protected:
    void run(std::vector<SessionHarness*> clients, int ticks = 12) {
        test::play(server, *world, std::move(clients), ticks);
    }
    static std::uint32_t id(const SessionHarness& client) {
        return client.conversation.stats().client_id;
    }
    // As an operator does.
    void as_server(Action action) {
        world->mailbox().push({.client = scene_client,
                               .sequence = ++sequence,
                               .action = std::move(action),
                               .reply = {}});
    }
    std::vector<std::string> chat(SessionHarness& client) {
        std::vector<std::string> texts;
        for (const v1::UserMessage& message : client.conversation.take_messages())
            texts.push_back(message.data());
        return texts;
    }
    // By sequence: refusals of a rate precede the results of earlier inputs.
    static std::vector<v1::InputResult> results(SessionHarness& client) {
        std::vector<v1::InputResult> results = client.conversation.take_results();
        std::ranges::sort(results, {}, &v1::InputResult::sequence);
        return results;
    }
    std::vector<std::string> codes(SessionHarness& client) {
        std::vector<std::string> codes;
        for (const v1::InputResult& result : results(client))
            codes.push_back(v1::InputCode_Name(result.code()) + " " + result.message());
        return codes;
    }

    TestServer server;
    std::shared_ptr<WorldHost> world = server.host(test::small_scene());
    std::uint32_t sequence = 0;
};

TEST_F(DataSectionsTest, every_client_has_the_player_list) {
    SessionHarness ann(server, options("ann"));
    run({&ann});
    client::ClientOptions watcher = options("bob");
    watcher.spectator = true;
    watcher.color = 0x3366cc;
    SessionHarness bob(server, watcher);
    run({&ann, &bob});
    for (const SessionHarness* client : {&ann, &bob}) {
        const auto& players = client->conversation.view().data().players();
        ASSERT_EQ(players.size(), 2u);
        EXPECT_EQ(players.at(id(ann)).name(), "ann");
        EXPECT_EQ(players.at(id(ann)).role(), v1::PLAYER_ROLE_PLAYER);
        EXPECT_EQ(players.at(id(bob)).role(), v1::PLAYER_ROLE_SPECTATOR);
        EXPECT_EQ(players.at(id(bob)).color(), 0x3366ccu);
        EXPECT_GT(players.at(id(bob)).joined_tick(), players.at(id(ann)).joined_tick());
    }
    bob.conversation.send(client::rename_input("rob"));
    run({&ann, &bob});
    bob.session->on_peer_closed(server.now);
    run({&ann});
    EXPECT_TRUE(ann.conversation.view().data().players().at(id(bob)).disconnected());
    const std::uint32_t before = id(bob);
    bob.connect();
    run({&ann, &bob});
    EXPECT_EQ(id(bob), before);
    bob.conversation.leave();
    run({&ann, &bob});
    std::vector<v1::PlayerEventKind> kinds;
    for (const v1::PlayerEvent& event : ann.conversation.take_player_events())
        if (event.player().client() == before) kinds.push_back(event.kind());
    EXPECT_EQ(kinds, (std::vector{v1::PLAYER_EVENT_KIND_JOINED, v1::PLAYER_EVENT_KIND_RENAMED,
                                  v1::PLAYER_EVENT_KIND_DISCONNECTED, v1::PLAYER_EVENT_KIND_RESUMED,
                                  v1::PLAYER_EVENT_KIND_LEFT}));
    EXPECT_EQ(ann.conversation.view().data().players().size(), 1u);
}

TEST_F(DataSectionsTest, clients_receive_the_room_as_their_role_may_see_it) {
    RoomProperties properties{.title = "Night race", .join_code = "sesame"};
    ASSERT_TRUE(set_permission(properties, "player.explode", "none").ok());
    world = *server.worlds.create("race", test::small_scene(), "", std::move(properties));
    client::ClientOptions hello{.world = "race", .room = true, .join_code = "sesame"};
    SessionHarness owner(server, hello);
    run({&owner});
    SessionHarness player(server, hello);
    run({&owner, &player});
    const auto room = [](const SessionHarness& of) { return of.conversation.view().data().room(); };
    ASSERT_TRUE(room(owner) && room(player));
    EXPECT_EQ(room(owner)->settings().join_code(), "sesame");
    EXPECT_EQ(room(player)->settings().join_code(), "") << "only for those who may change it";
    EXPECT_EQ(room(player)->settings().title(), "Night race");
    ASSERT_EQ(room(player)->settings().permissions_size(), 1) << "only the replaced entries";
    EXPECT_EQ(room(player)->settings().permissions().at("player.explode"), "none");

    as_server(RoomCommand{UpdateRoom{std::make_shared<const RoomProperties>(
        RoomProperties{.title = "Day race", .join_code = "thyme"})}});
    run({&owner, &player});
    EXPECT_EQ(room(owner)->settings().join_code(), "thyme");
    EXPECT_EQ(room(player)->settings().title(), "Day race");
    EXPECT_EQ(room(player)->settings().permissions_size(), 0);

    // A new owner sees the code, and the former one no longer does.
    as_server(RoomCommand{SetRole{id(player), PlayerRole::owner}});
    run({&owner, &player});
    EXPECT_EQ(room(player)->settings().join_code(), "thyme");
    EXPECT_EQ(room(owner)->settings().join_code(), "");
}

TEST_F(DataSectionsTest, pings_arrive_once_per_second) {
    SessionHarness ann(server, options("ann"), {.latency_ms = 40});
    run({&ann}, 180);
    const std::uint32_t ping = ann.conversation.view().data().players().at(id(ann)).ping_ms();
    EXPECT_GE(ping, 70u);
    EXPECT_LE(ping, 130u) << "twice 40 ms and the time until a tick";
}

TEST_F(DataSectionsTest, attributes_reach_only_clients_that_may_read_them) {
    SessionHarness ann(server, options("ann")), bob(server, options("bob"));
    run({&ann, &bob});
    as_server(SetRoleCommand{id(bob), PlayerRole::builder});
    const AttributeTarget anns = AttributeTarget::player(id(ann));
    ann.conversation.send(attributes_input(
        anns,
        {attribute("all", 1), attribute("mine", 2, v1::ATTRIBUTE_VISIBILITY_OWNER),
         attribute("builders", 3, v1::ATTRIBUTE_VISIBILITY_ROLES, 1 << v1::PLAYER_ROLE_BUILDER)}));
    run({&ann, &bob});
    EXPECT_EQ(value(ann, anns, "all"), 1);
    EXPECT_EQ(value(ann, anns, "mine"), 2);
    EXPECT_EQ(value(ann, anns, "builders"), -1);
    EXPECT_EQ(value(bob, anns, "all"), 1);
    EXPECT_EQ(value(bob, anns, "mine"), -1);
    EXPECT_EQ(value(bob, anns, "builders"), 3);

    // Visibility changes in both directions.
    ann.conversation.send(attributes_input(
        anns, {attribute("all", 4, v1::ATTRIBUTE_VISIBILITY_OWNER), attribute("mine", 5)}));
    run({&ann, &bob});
    EXPECT_EQ(value(ann, anns, "all"), 4);
    EXPECT_EQ(value(ann, anns, "mine"), 5);
    EXPECT_EQ(value(bob, anns, "all"), -1);
    EXPECT_EQ(value(bob, anns, "mine"), 5);

    // So do roles.
    as_server(SetRoleCommand{id(ann), PlayerRole::builder});
    as_server(SetRoleCommand{id(bob), PlayerRole::player});
    run({&ann, &bob});
    EXPECT_EQ(value(ann, anns, "builders"), 3);
    EXPECT_EQ(value(bob, anns, "builders"), -1);

    SessionHarness late(server, options("late"));
    run({&ann, &bob, &late});
    EXPECT_EQ(value(late, anns, "mine"), 5);
    EXPECT_EQ(value(late, anns, "all"), -1);
    ann.conversation.leave();
    run({&ann, &bob, &late});
    EXPECT_TRUE(bob.conversation.view().data().attributes().empty());
    EXPECT_EQ(bob.conversation.stats().decode_errors, 0u);
}

TEST_F(DataSectionsTest, attributes_of_the_world_for_owners) {
    SessionHarness ann(server, options("ann")), bob(server, options("bob"));
    run({&ann, &bob});
    as_server(SetAttributesCommand{
        {}, {{"secret", std::int64_t{7}, AttributeVisibility::owner}, {"open", std::int64_t{1}}}});
    as_server(SetRoleCommand{id(bob), PlayerRole::owner});
    run({&ann, &bob});
    EXPECT_EQ(value(ann, AttributeTarget::world(), "secret"), -1);
    EXPECT_EQ(value(bob, AttributeTarget::world(), "secret"), 7);
    EXPECT_TRUE(
        ann.conversation.view().data().attribute(AttributeTarget::world(), "open")->read_only());
    bob.conversation.send(attributes_input(AttributeTarget::world(), {attribute("open", 2)}));
    run({&ann, &bob});
    EXPECT_EQ(codes(bob),
              std::vector<std::string>{"INPUT_CODE_NOT_ALLOWED attribute \"open\" of the world was "
                                       "set by the server; clients cannot change it"});
    as_server(SetAttributesCommand{{}, {{"secret", {}}}});
    run({&ann, &bob});
    EXPECT_EQ(value(bob, AttributeTarget::world(), "secret"), -1);
}

TEST_F(DataSectionsTest, messages_arrive_once_in_order_and_only_at_their_recipients) {
    client::ClientOptions only_game = options("cy");
    only_game.topics = {"game"};
    SessionHarness ann(server, options("ann")), bob(server, options("bob")), cy(server, only_game);
    run({&ann, &bob, &cy});
    ann.conversation.send(message_input("chat", "1"));
    ann.conversation.send(message_input("chat", "2 for bob", {id(bob)}));
    ann.conversation.send(message_input("game", "3"));
    ann.conversation.send(client::server_message_input("game", "4 for the server"));
    bob.conversation.send(message_input("chat", "5 for no one", {12345}));
    run({&ann, &bob, &cy});
    EXPECT_EQ(chat(ann), (std::vector<std::string>{"1", "3"}));
    EXPECT_EQ(chat(bob), (std::vector<std::string>{"1", "2 for bob", "3"}));
    EXPECT_EQ(chat(cy), std::vector<std::string>{"3"});
    EXPECT_EQ(codes(bob),
              std::vector<std::string>{"INPUT_CODE_NOT_FOUND player 12345 does not exist"});
    as_server(SendMessageCommand{"game", "from the server"});
    run({&ann, &bob, &cy});
    EXPECT_EQ(chat(cy), std::vector<std::string>{"from the server"});
}

TEST_F(DataSectionsTest, a_broken_connection_loses_and_repeats_no_message) {
    SessionHarness ann(server, options("ann"), {.latency_ms = 60}), bob(server, options("bob"));
    run({&ann, &bob}, 30);
    std::vector<std::string> received, sent;
    for (int round = 0; round < 6; round++) {
        for (int k = 0; k < 8; k++) {
            sent.push_back(std::to_string(round) + "." + std::to_string(k));
            bob.conversation.send(message_input("chat", sent.back()));
            run({&ann, &bob}, 13);
        }
        // Messages are in flight.
        ann.session->on_peer_closed(server.now);
        ann.drop_in_flight();
        run({&bob}, 5);
        ann.connect();
    }
    run({&ann, &bob}, 60);
    for (std::string& text : chat(ann)) received.push_back(std::move(text));
    EXPECT_EQ(received, sent);
    EXPECT_EQ(ann.conversation.stats().resumed, 6u);
    EXPECT_EQ(ann.conversation.stats().messages_missed, 0u);
}

TEST_F(DataSectionsTest, rates_are_limited_with_the_time_to_retry) {
    SessionHarness ann(server, options("ann"));
    run({&ann});
    for (int k = 0; k < 12; k++) ann.conversation.send(message_input("chat", "x"));
    run({&ann});
    const std::vector<v1::InputResult> results = this->results(ann);
    ASSERT_EQ(results.size(), 12u);
    EXPECT_EQ(results[9].code(), v1::INPUT_CODE_APPLIED);
    EXPECT_EQ(results[10].code(), v1::INPUT_CODE_LIMIT);
    EXPECT_EQ(results[10].message(),
              "more than 5 messages per second (client.user_messages_per_second)");
    EXPECT_GE(results[10].retry_after_ms(), 150u);
    EXPECT_LE(results[10].retry_after_ms(), 201u);
    std::vector<v1::Attribute> ten;
    for (const char* key : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"})
        ten.push_back(attribute(key, 1));
    for (int k = 0; k < 11; k++)
        ann.conversation.send(attributes_input(AttributeTarget::player(id(ann)), ten));
    run({&ann});
    const std::vector<std::string> attribute_codes = codes(ann);
    ASSERT_EQ(attribute_codes.size(), 11u);
    EXPECT_EQ(attribute_codes[9], "INPUT_CODE_APPLIED ");
    EXPECT_EQ(attribute_codes[10],
              "INPUT_CODE_LIMIT more than 100 attribute changes per second "
              "(client.attribute_changes_per_second)");
}

TEST_F(DataSectionsTest, invalid_inputs_name_their_field) {
    SessionHarness ann(server, options("ann"));
    run({&ann});
    ann.conversation.send(message_input("Chat", "x"));
    ann.conversation.send(message_input("chat", std::string(1025, 'x')));
    ann.conversation.send(message_input("chat", "x", std::vector<std::uint32_t>(17, 1)));
    ann.conversation.send(client::rename_input(""));
    ann.conversation.send(attributes_input(AttributeTarget::player(id(ann)), {}));
    ann.conversation.send(
        attributes_input(AttributeTarget::player(id(ann)), {attribute("a", 1), attribute("B", 1)}));
    v1::Input no_target;
    *no_target.mutable_set_attributes()->mutable_set()->add_attributes() = attribute("a", 1);
    ann.conversation.send(no_target);
    run({&ann});
    const std::vector<std::string> found = codes(ann);
    const std::vector<std::string> expected{
        "INPUT_CODE_INVALID send_message.topic is invalid; it must be 1 to 32 of the characters "
        "a-z, 0-9, '_' and '.'",
        "INPUT_CODE_INVALID send_message.data has 1025 bytes; client.user_message_bytes_max allows "
        "1024",
        "INPUT_CODE_INVALID send_message.to has 17 entries; at most 16 are allowed",
        "INPUT_CODE_INVALID rename.name has 0 bytes; it must have 1 to 32",
        "INPUT_CODE_INVALID set_attributes.set.attributes has 0 entries; 1 to 64 are allowed",
        "INPUT_CODE_INVALID set_attributes.set.attributes[1].key is invalid; it must be 1 to 32 of "
        "the characters a-z, 0-9, '_' and '.'",
        "INPUT_CODE_INVALID set_attributes.set.target is not set; set entity, player, or world to "
        "true"};
    EXPECT_EQ(found, expected);
}

TEST_F(DataSectionsTest, clients_that_did_not_subscribe_receive_nothing) {
    SessionHarness ann(server, options("ann")), bare(server, {.name = "bare"});
    run({&ann, &bare}, 120);
    const auto bytes_of = [&](int ticks) {
        const std::uint64_t before = bare.conversation.stats().bytes_received;
        run({&ann, &bare}, ticks);
        return bare.conversation.stats().bytes_received - before;
    };
    const std::uint64_t quiet = bytes_of(120);
    for (int k = 0; k < 5; k++) ann.conversation.send(message_input("chat", std::string(900, 'x')));
    ann.conversation.send(attributes_input(AttributeTarget::player(id(ann)), {attribute("x", 1)}));
    const std::uint64_t busy = bytes_of(120);
    EXPECT_EQ(chat(ann).size(), 5u);
    EXPECT_LT(busy, quiet + 200);
    EXPECT_TRUE(bare.conversation.view().data().players().empty());
}

TEST_F(DataSectionsTest, a_requested_keyframe_carries_complete_lists) {
    SessionHarness ann(server, options("ann"));
    run({&ann});
    ann.conversation.send(attributes_input(AttributeTarget::player(id(ann)), {attribute("x", 1)}));
    run({&ann});
    int complete_players = 0, complete_attributes = 0, keyframes = 0;
    ann.tamper = [&](std::string& bytes) {
        v1::ServerMessage message;
        ASSERT_TRUE(message.ParseFromString(bytes));
        for (const auto& update : message.snapshot().players())
            complete_players += update.complete() && update.players_size() == 1 ? 1 : 0;
        for (const auto& update : message.snapshot().attributes())
            complete_attributes += update.complete() && update.sets_size() == 1 ? 1 : 0;
        if (message.has_snapshot() && message.snapshot().baselines() == 0) {
            keyframes++;
            EXPECT_EQ(complete_players, 1) << "in the same snapshot";
            EXPECT_EQ(complete_attributes, 1);
        }
    };
    ann.conversation.request_keyframe();
    run({&ann}, 60);
    EXPECT_EQ(keyframes, 1);
    EXPECT_EQ(value(ann, AttributeTarget::player(id(ann)), "x"), 1);
}

}  // namespace
}  // namespace jostle::server
