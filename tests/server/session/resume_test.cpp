// SPDX-License-Identifier: MIT
//
// Connections break in the midst of play, and clients come back: what is still theirs, what they
// are told again, and what is applied once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>

#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::SessionHarness;
using test::TestServer;

v1::Input falling_ball(double x, double y = 20) {
    v1::Input input;
    input.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(0.3);
    input.mutable_spawn()->mutable_position()->set_x(x);
    input.mutable_spawn()->mutable_position()->set_y(y);
    return input;
}

int bodies_of(const WorldHost& world, ClientId client) {
    int owned = 0;
    for (const auto& entity : *world.frame()->entity_list) owned += entity->owner == client ? 1 : 0;
    return owned;
}

class ResumeTest : public testing::Test {
protected:
    void SetUp() override { world = server.host(test::small_scene()); }
    // The connection breaks; what was on the way is lost.
    void cut(SessionHarness& player) {
        player.session->on_peer_closed(server.now);
        player.conversation.ended(Error{ErrorCode::unavailable, "the line broke"});
        player.drop_in_flight();
    }
    void run(SessionHarness& player, int ticks) { test::play(server, *world, {&player}, ticks); }
    void run_alone(int ticks) { test::play(server, *world, {}, ticks); }
    std::set<std::uint32_t> entities_known(const SessionHarness& player) const {
        std::set<std::uint32_t> ids;
        for (const auto& [id, entity] : player.conversation.view().entities()) ids.insert(id);
        return ids;
    }
    std::set<std::uint32_t> entities_there() const {
        std::set<std::uint32_t> ids;
        for (const auto& entity : *world->frame()->entity_list) ids.insert(entity->id);
        return ids;
    }

    TestServer server;
    std::shared_ptr<WorldHost> world;
};

TEST_F(ResumeTest, resume_within_timeout_preserves_identity_and_bodies) {
    SessionHarness player(server, {.name = "player"});
    for (int i = 0; i < 3; i++) player.conversation.send(falling_ball(i));
    run(player, 30);
    const ClientId id = player.conversation.stats().client_id;
    EXPECT_EQ(bodies_of(*world, id), 3);
    cut(player);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 1u);
    EXPECT_EQ(server.context.connected_clients.status(server.now).size(), 0u)
        << "he is not connected";
    run_alone(120);
    remove_expired_clients(server.context, server.now);
    EXPECT_EQ(bodies_of(*world, id), 3) << "lost, and not left";
    player.connect();
    run(player, 30);
    const client::ClientStats stats = player.conversation.stats();
    EXPECT_EQ(stats.client_id, id);
    EXPECT_EQ(stats.resumed, 1u);
    EXPECT_EQ(stats.decode_errors, 0u) << stats.last_error;
    EXPECT_EQ(bodies_of(*world, id), 3);
    EXPECT_EQ(entities_known(player), entities_there());
    EXPECT_EQ(server.sessions.clients(), 1);
}

// Another host goes on with a world in which two played; one of them is there no more.
TEST_F(ResumeTest, world_restart_removes_disconnected_clients_and_retains_connected_ones) {
    SessionHarness player(server, {.name = "player"});
    player.conversation.send(falling_ball(0));
    run(player, 20);
    const ClientId here = player.conversation.stats().client_id, gone = here + 1;
    SpawnCommand ball;
    ball.shape.geometry = physics::Sphere{0.3};
    ball.pose.position = {3, 9, 3};
    world->mailbox().push({.client = gone, .sequence = 1, .action = ball, .reply = nullptr});
    run(player, 2);
    ASSERT_EQ(bodies_of(*world, here), 1);
    ASSERT_EQ(bodies_of(*world, gone), 1);
    reconcile_clients(server.context, *world, std::array{here, gone});
    run(player, 2);
    EXPECT_EQ(bodies_of(*world, here), 1);
    EXPECT_EQ(bodies_of(*world, gone), 0);
}

TEST_F(ResumeTest, client_leaves_after_the_resume_timeout) {
    SessionHarness player(server, {.name = "player"});
    player.conversation.send(falling_ball(0));
    run(player, 30);
    const ClientId id = player.conversation.stats().client_id;
    cut(player);
    remove_expired_clients(server.context, server.now + 29s);
    run_alone(2);
    EXPECT_EQ(bodies_of(*world, id), 1);
    remove_expired_clients(server.context, server.now + 31s);
    run_alone(2);
    EXPECT_EQ(bodies_of(*world, id), 0);
    EXPECT_EQ(server.sessions.clients(), 0);
    player.connect();
    run(player, 30);
    EXPECT_NE(player.conversation.stats().client_id, id) << "he is somebody new";
    EXPECT_EQ(player.conversation.stats().resumed, 0u);
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
    EXPECT_EQ(entities_known(player), entities_there());
}

TEST_F(ResumeTest, leave_and_non_resumable_disconnect_are_immediate) {
    SessionHarness polite(server, {.name = "polite"}),
        old(server, {.name = "old", .resume = false});
    test::play(server, *world, {&polite, &old}, 30);
    polite.conversation.leave();
    test::play(server, *world, {&polite, &old}, 3);
    EXPECT_EQ(server.sessions.clients(), 1);
    cut(old);
    EXPECT_EQ(server.sessions.clients(), 0);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 0u);
}

TEST_F(ResumeTest, disconnect_during_drain_is_final) {
    SessionHarness player(server, {.name = "player"});
    run(player, 30);
    server.context.draining = true;
    cut(player);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 0u);
    EXPECT_EQ(server.sessions.clients(), 0);
}

// The link is cut at every phase of a batch: before it came, before its answer came, after both.
TEST_F(ResumeTest, applies_every_input_exactly_once_across_disconnects) {
    for (const double latency_ms : {0.0, 40.0, 120.0}) {
        SessionHarness player(server, {.name = "player"}, {.latency_ms = latency_ms});
        run(player, 40);
        std::set<std::uint32_t> answered;
        std::uint32_t sent = 0;
        const auto collect = [&] {
            for (const v1::InputResult& result : player.conversation.take_results()) {
                EXPECT_EQ(result.code(), v1::INPUT_CODE_APPLIED) << result.message();
                EXPECT_TRUE(answered.insert(result.sequence()).second) << "told once";
            }
        };
        for (int i = 0; i < 8; i++) {
            for (int k = 0; k < 3; k++)
                sent = player.conversation.send(falling_ball(k, 20 + 2 * i));
            run(player, 1 + i);
            collect();
            cut(player);
            run_alone(i % 3);
            player.connect();
            if (i % 2 == 0) run(player, 20);
        }
        run(player, 60);
        collect();
        EXPECT_EQ(sent, 24u);
        EXPECT_EQ(answered.size(), 24u) << "each is answered, though answers were lost";
        const ClientId id = player.conversation.stats().client_id;
        EXPECT_EQ(bodies_of(*world, id), 24) << "and none was applied twice";
        EXPECT_EQ(player.conversation.stats().decode_errors, 0u)
            << player.conversation.stats().last_error;
        EXPECT_EQ(entities_known(player), entities_there());
        player.conversation.leave();
        run(player, 30);
    }
}

TEST_F(ResumeTest, snapshots_continue_from_the_last_received_frame) {
    SessionHarness player(server, {.name = "player"});
    int absolute = 0, snapshots = 0, entity_updates = 0;
    player.tamper = [&](std::string& bytes) {
        v1::ServerMessage message;
        ASSERT_TRUE(message.ParseFromString(bytes));
        snapshots += message.has_snapshot() ? 1 : 0;
        absolute += message.has_snapshot() && message.snapshot().baselines() == 0 ? 1 : 0;
        entity_updates += message.has_entity_update() ? 1 : 0;
    };
    player.conversation.send(falling_ball(0));
    run(player, 20);
    EXPECT_EQ(absolute, 1);
    EXPECT_EQ(entity_updates, 2) << "the entities of the world, and the ball";
    cut(player);
    run_alone(10);
    player.connect();
    snapshots = absolute = entity_updates = 0;
    run(player, 20);
    EXPECT_GT(snapshots, 10);
    EXPECT_EQ(absolute, 0) << "the base was in the ring";
    EXPECT_EQ(entity_updates, 0) << "and no entity is added twice";
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

TEST_F(ResumeTest, resume_removes_entities_deleted_while_disconnected) {
    SessionHarness watcher(server, {.name = "watcher"}), maker(server, {.name = "maker"});
    test::play(server, *world, {&watcher, &maker}, 20);
    maker.conversation.send(falling_ball(0));
    test::play(server, *world, {&watcher, &maker}, 5);
    // The watcher hears of the ball, and no snapshot with it; then his line breaks.
    const std::set<std::uint32_t> with_ball = entities_known(watcher);
    cut(watcher);
    v1::Input removal;
    removal.mutable_delete_()->set_entity(*with_ball.rbegin());
    maker.conversation.send(removal);
    maker.conversation.send(falling_ball(3));
    test::play(server, *world, {&maker}, 5);
    watcher.connect();
    test::play(server, *world, {&watcher, &maker}, 5);
    EXPECT_EQ(entities_known(watcher), entities_there());
    EXPECT_EQ(watcher.conversation.stats().decode_errors, 0u);
}

TEST_F(ResumeTest, resume_supersedes_a_session_not_yet_closed) {
    SessionHarness player(server, {.name = "player"});
    player.conversation.send(falling_ball(0));
    run(player, 30);
    const ClientId id = player.conversation.stats().client_id;
    // The old link is still there, and hears nothing.
    player.conversation.ended(Error{ErrorCode::unavailable, "another network"});
    ClientSession& before = *player.session;
    ClientSession now_on(server.context,
                         {.name = "test",
                          .address = "127.0.0.1",
                          .call = "jostle.v1.PlayService/Play",
                          .who = server.authorizer->identify({.address = "127.0.0.1"})},
                         server.now);
    player.conversation.begin(server.now);
    now_on.receive(*player.conversation.take_message(server.now), server.now);
    EXPECT_FALSE(now_on.take_message(server.now)) << "it waits for the old link to give way";
    before.take_message(server.now);
    ASSERT_TRUE(before.end());
    EXPECT_FALSE(before.end()->ok());
    server.now += 50ms;
    const auto welcome = now_on.take_message(server.now);
    ASSERT_TRUE(welcome);
    player.conversation.receive(welcome->header, server.now);
    EXPECT_EQ(player.conversation.stats().client_id, id);
    EXPECT_EQ(player.conversation.stats().resumed, 1u);
    EXPECT_EQ(bodies_of(*world, id), 1);
}

TEST_F(ResumeTest, rejects_foreign_resume_tokens) {
    SessionHarness player(server, {.name = "player"});
    run(player, 30);
    const ClientId id = player.conversation.stats().client_id;
    cut(player);
    for (const std::string& token : {std::string(), std::string(16, '\0'), std::string(256, 'x')}) {
        SessionHarness thief(server, {.name = "thief"});
        v1::ClientMessage hello;
        hello.mutable_hello()->set_protocol(1);
        hello.mutable_hello()->mutable_resume()->set_token(token);
        ClientSession session(server.context,
                              {.name = "thief",
                               .address = "127.0.0.1",
                               .call = "jostle.v1.PlayService/Play",
                               .who = server.authorizer->identify({.address = "127.0.0.1"})},
                              server.now);
        session.receive(hello.SerializeAsString(), server.now);
        v1::ServerMessage welcome;
        ASSERT_TRUE(welcome.ParseFromString(session.take_message(server.now)->header));
        EXPECT_FALSE(welcome.welcome().resumed());
        EXPECT_NE(welcome.welcome().client_id(), id);
        session.on_peer_closed(server.now);
    }
    EXPECT_EQ(server.context.resume_registry.disconnected(), 1u) << "his place is still kept";
}

// By a ticket he comes in once, and again as no more than he was.
TEST_F(ResumeTest, ticketed_spectator_resumes_as_spectator) {
    const std::string ticket =
        server.authorizer
            ->issue_ticket({.subject = "ann", .role = Role::player, .anonymous = false},
                           world->id(), "127.0.0.1")
            .value();
    SessionHarness watcher(server, {.ticket = ticket, .name = "watcher", .spectator = true});
    run(watcher, 30);
    ASSERT_TRUE(watcher.conversation.stats().connected) << watcher.conversation.stats().last_error;
    cut(watcher);
    watcher.connect();
    run(watcher, 30);
    EXPECT_EQ(watcher.conversation.stats().resumed, 1u) << watcher.conversation.stats().last_error;
    cut(watcher);
    // The same Hello, but for what he wants to be.
    watcher.session.emplace(server.context,
                            Peer{.name = "test",
                                 .address = "127.0.0.1",
                                 .call = "jostle.v1.PlayService/Play",
                                 .who = server.authorizer->identify({.address = "127.0.0.1"})},
                            server.now);
    watcher.conversation.begin(server.now);
    v1::ClientMessage hello;
    ASSERT_TRUE(hello.ParseFromString(*watcher.conversation.take_message(server.now)));
    hello.mutable_hello()->set_spectator(false);
    watcher.session->receive(hello.SerializeAsString(), server.now);
    ASSERT_TRUE(watcher.session->end());
    EXPECT_EQ(watcher.session->end()->error().code, ErrorCode::permission_denied);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 1u) << "his place is still kept";
}

// A client in the world "yard" that joined by a ticket of `who`.
struct Ticketed {
    static std::string ticket_of(TestServer& server, const WorldHost& world, const Identity& who) {
        return server.authorizer->issue_ticket(who, world.id(), "127.0.0.1").value();
    }
    static Identity player(std::string subject) {
        return {.subject = std::move(subject), .role = Role::player, .anonymous = false};
    }
};

// The first messages of another connection that shows this resume token and this ticket.
struct Attempt {
    Attempt(TestServer& server, const std::string& resume_token, const std::string& ticket)
        : session(server.context,
                  {.name = "attempt",
                   .address = "127.0.0.1",
                   .call = "jostle.v1.PlayService/Play",
                   .who = server.authorizer->identify({.address = "127.0.0.1"})},
                  server.now) {
        v1::ClientMessage hello;
        hello.mutable_hello()->set_protocol(1);
        hello.mutable_hello()->set_resumable(true);
        hello.mutable_hello()->set_ticket(ticket);
        hello.mutable_hello()->mutable_resume()->set_token(resume_token);
        session.receive(hello.SerializeAsString(), server.now);
    }
    v1::Welcome welcome(TestServer& server) {
        const auto message = session.take_message(server.now);
        v1::ServerMessage parsed;
        if (message) parsed.ParseFromString(message->header);
        return parsed.welcome();
    }
    std::string refusal() const {
        return session.end() && !session.end()->ok() ? session.end()->error().message : "";
    }

    ClientSession session;
};

TEST_F(ResumeTest, foreign_attempts_never_end_a_running_session) {
    const std::string ticket = Ticketed::ticket_of(server, *world, Ticketed::player("ann"));
    Attempt victim(server, "", ticket);
    const v1::Welcome joined = victim.welcome(server);
    ASSERT_FALSE(joined.resume_token().empty());
    std::string forged = joined.resume_token();
    forged.back() ^= 1;
    const std::pair<std::string, std::string> foreign[] = {
        {joined.resume_token(), ""},                    // the session token alone
        {joined.resume_token(), std::string(32, '0')},  // with a forged ticket
        {joined.resume_token(),                         // with a ticket of another subject
         Ticketed::ticket_of(server, *world, Ticketed::player("eve"))},
        {forged, Ticketed::ticket_of(server, *world, Ticketed::player("eve"))}};
    const char* expected[] = {
        "hello.resume.token: the session belongs to an authenticated client; send its token or a "
        "ticket as well",
        "the ticket is invalid or no longer valid; get a new one from JoinWorld",
        "hello.resume.token: the session belongs to another subject", ""};
    for (int i = 0; i < 4; i++) {
        Attempt attempt(server, foreign[i].first, foreign[i].second);
        EXPECT_EQ(attempt.refusal(), expected[i]);
        if (i == 3) {
            EXPECT_NE(attempt.welcome(server).client_id(), joined.client_id());
        }
        for (int k = 0; k < 5; k++) {
            world->tick(server.now);
            while (victim.session.take_message(server.now)) {
            }
            server.now += 50ms;
        }
        EXPECT_FALSE(victim.session.end()) << "attempt " << i;
    }
    // The client itself takes over its session, by the ticket of the session or by a new one.
    const std::string fresh = Ticketed::ticket_of(server, *world, Ticketed::player("ann"));
    ClientSession* before = &victim.session;
    std::vector<std::unique_ptr<Attempt>> own;
    for (const std::string& shown : {ticket, fresh}) {
        own.push_back(std::make_unique<Attempt>(server, joined.resume_token(), shown));
        EXPECT_FALSE(own.back()->session.take_message(server.now)) << "the older one still runs";
        while (before->take_message(server.now)) {
        }
        ASSERT_TRUE(before->end());
        const v1::Welcome resumed = own.back()->welcome(server);
        EXPECT_TRUE(resumed.resumed());
        EXPECT_EQ(resumed.client_id(), joined.client_id());
        before = &own.back()->session;
    }
    Attempt old_ticket(server, joined.resume_token(), ticket);
    EXPECT_FALSE(old_ticket.refusal().empty()) << "the new ticket replaced it";
}

TEST_F(ResumeTest, anonymous_session_is_not_resumed_by_an_authenticated_client) {
    Attempt anonymous(server, "", "");
    const v1::Welcome joined = anonymous.welcome(server);
    Attempt eve(server, joined.resume_token(),
                Ticketed::ticket_of(server, *world, Ticketed::player("eve")));
    EXPECT_EQ(eve.refusal(), "hello.resume.token: the session belongs to another subject");
    server.now += 100ms;
    anonymous.session.take_message(server.now);
    EXPECT_FALSE(anonymous.session.end());
}

TEST_F(ResumeTest, session_ends_with_its_token_and_resumes_with_a_new_one) {
    Identity ann = Ticketed::player("ann");
    ann.expires = std::chrono::system_clock::now() + 300ms;
    const std::string ticket = Ticketed::ticket_of(server, *world, ann);
    Attempt session(server, "", ticket);
    const v1::Welcome joined = session.welcome(server);
    std::this_thread::sleep_for(310ms);
    server.now += 260ms;
    while (session.session.take_message(server.now)) {
    }
    ASSERT_TRUE(session.session.end());
    EXPECT_EQ(session.session.end()->error().code, ErrorCode::unauthenticated);
    EXPECT_EQ(session.refusal(), "the token of the session has expired; resume with a new token");
    EXPECT_EQ(server.context.resume_registry.disconnected(), 1u) << "its bodies wait for it";
    Attempt with_old(server, joined.resume_token(), ticket);
    EXPECT_EQ(with_old.refusal(), "the token of the session has expired; resume with a new token");
    Attempt with_new(server, joined.resume_token(),
                     Ticketed::ticket_of(server, *world, Ticketed::player("ann")));
    const v1::Welcome resumed = with_new.welcome(server);
    EXPECT_TRUE(resumed.resumed());
    EXPECT_EQ(resumed.client_id(), joined.client_id());
}

TEST_F(ResumeTest, banned_client_neither_continues_nor_resumes) {
    const std::string ticket = Ticketed::ticket_of(server, *world, Ticketed::player("ann"));
    Attempt session(server, "", ticket), other(server, "", "");
    const v1::Welcome joined = session.welcome(server);
    session.session.on_peer_closed(server.now);
    ASSERT_EQ(server.context.resume_registry.disconnected(), 1u);
    const auto wall = std::chrono::system_clock::now();
    ASSERT_TRUE(
        server.authorizer->bans().add({.target = {"ann", {}}, .reason = "spamming"}, wall).ok());
    EXPECT_EQ(Attempt(server, joined.resume_token(), ticket).refusal(),
              "the subject of the token is banned: spamming");
    other.session.take_message(server.now);
    EXPECT_FALSE(other.session.end());
    ASSERT_TRUE(server.authorizer->bans().remove({"ann", {}}, wall).ok());
    Attempt again(server, joined.resume_token(), ticket);
    EXPECT_TRUE(again.welcome(server).resumed());
}

TEST_F(ResumeTest, client_of_an_earlier_process_shows_its_ticket_again) {
    const std::string secret(32, 's'), ticket(32, 'a');
    server.context.resume_registry.use_secret(secret);
    const auto wall = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const auto sealed = [&](ClientId client, WallTime token_expires) {
        expect_resume(server.context, world, client, 5, server.now + 30s);
        return seal_token({.client = client,
                           .world = world->id(),
                           .subject = "ann",
                           .ticket = Tickets::digest(ticket),
                           .key = {},
                           .spectator = false,
                           .expires = wall + 24h,
                           .token_expires = token_expires},
                          secret)
            .value();
    };
    const std::string token = sealed(77, wall + 1h), old = sealed(78, wall - 1s);
    EXPECT_FALSE(Attempt(server, token, "").refusal().empty());
    EXPECT_FALSE(Attempt(server, token, std::string(32, 'b')).refusal().empty());
    EXPECT_EQ(Attempt(server, old, ticket).refusal(),
              "the token of the session has expired; resume with a new token");
    Attempt attempt(server, token, ticket);
    const v1::Welcome resumed = attempt.welcome(server);
    EXPECT_TRUE(resumed.resumed());
    EXPECT_EQ(resumed.client_id(), 77u);
}

TEST(SessionLimits, idle_players_are_disconnected_and_spectators_stay) {
    Config config;
    config.limits.idle_kick_seconds = 1;
    TestServer server(config);
    const auto world = server.host(test::small_scene());
    SessionHarness idle(server, {.name = "idle", .reconnect = false}),
        active(server, {.name = "active"}), watcher(server, {.name = "watcher", .spectator = true});
    for (int half_second = 0; half_second < 6; half_second++) {
        active.conversation.send(falling_ball(half_second));
        test::play(server, *world, {&idle, &active, &watcher}, 30);
        EXPECT_EQ(idle.session->end().has_value(), half_second >= 2) << half_second;
    }
    EXPECT_EQ(idle.session->end()->error().code, ErrorCode::deadline_exceeded);
    EXPECT_FALSE(active.session->end());
    EXPECT_FALSE(watcher.session->end());
    EXPECT_EQ(server.sessions.clients(), 2);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 0u);
}

TEST(SessionLimits, further_session_of_a_subject_replaces_only_a_suspended_one) {
    Config config;
    config.limits.sessions_per_subject = 1;
    TestServer server(config);
    const auto world = server.host(test::small_scene());
    const auto join = [&](const char* subject) {
        return std::make_unique<Attempt>(
            server, "", Ticketed::ticket_of(server, *world, Ticketed::player(subject)));
    };
    const auto first = join("ann"), second = join("ann"), other = join("bob");
    const ClientId id = first->welcome(server).client_id();
    EXPECT_EQ(second->refusal(),
              "the subject of the token already has 1 session, the maximum "
              "(limits.sessions_per_subject); end another one first");
    EXPECT_FALSE(first->session.end());
    EXPECT_FALSE(other->session.end());
    first->session.on_peer_closed(server.now);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 1u);
    const auto third = join("ann");
    EXPECT_GT(third->welcome(server).client_id(), id);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 0u) << "the suspended session left";
    const Attempt anonymous(server, "", ""), another(server, "", "");
    EXPECT_FALSE(anonymous.session.end());
    EXPECT_FALSE(another.session.end()) << "anonymous callers are not counted";
}

TEST(ResumeWithKeys, session_ends_when_its_key_is_removed) {
    const test::TempFolder folder;
    const test::LoginService login, other{.key_id = "second"};
    Config config;
    config.auth = {.issuer = test::LoginService::issuer,
                   .audience = test::LoginService::audience,
                   .keys = folder.write("keys.json", login.published())};
    TestServer server(config);
    const auto world = server.host(test::small_scene());
    const auto now = std::chrono::system_clock::now();
    const Identity ann =
        server.authorizer
            ->identify({.bearer = login.token(test::LoginService::claims("ann", "player", now)),
                        .address = "127.0.0.1"})
            .value();
    Attempt session(server, "", Ticketed::ticket_of(server, *world, ann));
    const std::string unused = Ticketed::ticket_of(server, *world, ann);
    ASSERT_NE(session.welcome(server).client_id(), 0u);
    server.authorizer->reload();
    while (session.session.take_message(server.now)) {
    }
    EXPECT_FALSE(session.session.end()) << "the key is still there";
    folder.write("keys.json", other.published());
    server.authorizer->reload();
    while (session.session.take_message(server.now)) {
    }
    ASSERT_TRUE(session.session.end());
    EXPECT_EQ(session.refusal(),
              "the key that signed the token of the session was removed; resume with a new token");
    EXPECT_EQ(Attempt(server, "", unused).refusal(),
              "the ticket is invalid or no longer valid; get a new one from JoinWorld");
}

TEST_F(ResumeTest, releases_grabs_while_disconnected) {
    SessionHarness player(server, {.name = "player"});
    run(player, 20);
    v1::Input grab, drag;
    grab.mutable_grab()->set_entity(3);
    grab.mutable_grab()->mutable_point()->set_y(1.5);
    drag.mutable_drag()->mutable_target()->set_y(4);
    player.conversation.send(grab);
    player.conversation.send(drag);
    run(player, 120);
    const auto height = [&] { return world->frame()->entities[2].pose.position.y; };
    EXPECT_GT(height(), 3);
    cut(player);
    run_alone(180);
    EXPECT_LT(height(), 2) << "it fell";
}

TEST_F(ResumeTest, suspended_sessions_yield_to_new_clients_when_full) {
    std::vector<std::unique_ptr<SessionHarness>> lost;
    for (int i = 0; i < 20; i++) {  // as many as the server takes
        lost.push_back(
            std::make_unique<SessionHarness>(server, client::ClientOptions{.name = "lost"}));
        run(*lost.back(), 5);
        cut(*lost.back());
    }
    EXPECT_EQ(server.context.resume_registry.disconnected(), 20u);
    SessionHarness player(server, {.name = "player"});
    run(player, 5);
    EXPECT_TRUE(player.conversation.stats().connected);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 19u);
    EXPECT_EQ(server.sessions.clients(), 20);
}

}  // namespace
}  // namespace jostle::server
