// SPDX-License-Identifier: MIT
//
// Conversations with real worlds over a transport in memory. The link's clock is an argument, so
// silences of many seconds take no time; the worlds tick in real time.
#include "server/session/client_session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "tests/system/play_state.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::PlayState;

class ClientSessionTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(worlds.create("", *scenes::find_scene("stack")).ok()); }

    Config config;
    SessionDirectory sessions{2};
    WorldDirectory worlds{{}, 4};
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
};

// One client: what it says goes straight to its link, what the link says to a PlayState.
struct TestClient {
    explicit TestClient(PlayContext& context)
        : session(context,
                  Peer{.name = "test",
                       .address = "127.0.0.1",
                       .call = "jostle.v1.PlayService/Play",
                       .who = context.authorizer.identify({.address = "127.0.0.1"})},
                  Clock::now()) {}

    void send(const v1::ClientMessage& message, Clock::duration later = 0s) {
        session.receive(message.SerializeAsString(), Clock::now() + later);
    }
    void hello(const std::function<void(v1::Hello&)>& change = [](v1::Hello&) {}) {
        v1::ClientMessage message;
        message.mutable_hello()->set_protocol(1);
        change(*message.mutable_hello());
        state.wants_events = message.hello().events();
        send(message);
    }
    void ack(std::uint32_t frame, bool need_keyframe = false) {
        v1::ClientMessage message;
        message.mutable_ack()->set_frame(frame);
        message.mutable_ack()->set_need_keyframe(need_keyframe);
        send(message);
    }
    void inputs(std::uint32_t first, std::vector<v1::Input> list) {
        v1::ClientMessage message;
        message.mutable_input()->set_first_sequence(first);
        for (v1::Input& input : list) *message.mutable_input()->add_inputs() = std::move(input);
        send(message);
    }
    // Takes all that the link has to say.
    void listen(Clock::duration later = 0s) {
        while (std::optional<OutMessage> out = session.take_message(Clock::now() + later)) {
            v1::ServerMessage message;
            const std::string bytes = out->concatenated();
            ASSERT_TRUE(message.ParseFromString(bytes));
            bytes_taken += bytes.size();
            kinds.push_back(message.message_case());
            if (message.has_snapshot()) {
                newest_shared = out->shared;
                newest_bases = message.snapshot().baselines();
            }
            state.take(message);
        }
    }
    // As a transport does while time passes; the client says nothing.
    void stay_silent(Clock::duration from, Clock::duration until) {
        for (auto later = from; later <= until; later += 100ms) listen(later);
    }
    bool listen_until(const std::function<bool()>& condition, bool acknowledge = true) {
        for (const auto end = Clock::now() + 5s; Clock::now() < end;) {
            listen();
            if (condition()) return true;
            if (acknowledge && state.newest_frame != 0) session.receive(ack_bytes(), Clock::now());
            std::this_thread::sleep_for(10ms);
        }
        return false;
    }
    std::string ack_bytes() const {
        v1::ClientMessage message;
        message.mutable_ack()->set_frame(state.newest_frame);
        return message.SerializeAsString();
    }

    ClientSession session;
    PlayState state;
    std::vector<v1::ServerMessage::MessageCase> kinds;
    SharedBytes newest_shared;
    std::size_t bytes_taken = 0;
    std::uint32_t newest_bases = 0;
};

v1::Input spawn_ball(double radius) {
    v1::Input input;
    input.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(radius);
    input.mutable_spawn()->mutable_position()->set_y(20);
    return input;
}

v1::Input removal(std::uint32_t entity) {
    v1::Input input;
    input.mutable_delete_()->set_entity(entity);
    return input;
}

TEST_F(ClientSessionTest, hello_returns_welcome_entity_update_and_keyframe) {
    TestClient client(context);
    client.listen();
    EXPECT_TRUE(client.kinds.empty()) << "the client speaks first";
    client.hello();
    client.listen();
    ASSERT_GE(client.kinds.size(), 3u);
    EXPECT_EQ(client.kinds[0], v1::ServerMessage::kWelcome);
    EXPECT_EQ(client.kinds[1], v1::ServerMessage::kEntityUpdate);
    EXPECT_EQ(client.kinds[2], v1::ServerMessage::kSnapshot);
    EXPECT_EQ(client.newest_bases, 0u);
    EXPECT_EQ(client.state.welcome.world_name(), "stack");
    EXPECT_EQ(client.state.welcome.tick_hz(), 60);
    EXPECT_EQ(client.state.entities.size(), worlds.find("")->frame()->entities.size());
    EXPECT_TRUE(client.listen_until([&] { return client.state.snapshots > 5; }));
    EXPECT_NE(client.newest_bases, 0u) << "later ones are deltas";
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
    EXPECT_EQ(sessions.clients(), 1);
}

TEST_F(ClientSessionTest, negotiates_the_highest_common_codec) {
    const auto welcomed = [&](std::uint32_t theirs, int ours) {
        config.stream.codec = ours;
        TestClient client(context);
        client.hello([&](v1::Hello& hello) { hello.set_codec(theirs); });
        EXPECT_TRUE(client.listen_until([&] { return client.state.snapshots > 3; }));
        EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
        return client.state.welcome.codec();
    };
    EXPECT_EQ(welcomed(0, 2), 1u) << "who says nothing knows the first";
    EXPECT_EQ(welcomed(1, 2), 1u);
    EXPECT_EQ(welcomed(2, 2), 2u);
    EXPECT_EQ(welcomed(7, 2), 2u);
    EXPECT_EQ(welcomed(2, 1), 1u) << "the operator may keep to the first";
}

TEST_F(ClientSessionTest, clients_with_equal_rate_share_encoded_bytes) {
    TestClient one(context), two(context);
    one.hello();
    two.hello();
    int shared = 0;
    ASSERT_TRUE(one.listen_until([&] {
        two.listen();
        two.ack(two.state.newest_frame);
        shared += one.state.newest_frame == two.state.newest_frame &&
                  one.newest_shared == two.newest_shared;
        return shared > 5;
    }));
    EXPECT_EQ(one.state.violations + two.state.violations, 0);
}

TEST_F(ClientSessionTest, applies_and_acknowledges_each_input_once) {
    TestClient client(context);
    client.hello();
    client.inputs(1, {spawn_ball(0.3), spawn_ball(0.2)});
    client.inputs(2, {spawn_ball(0.2), spawn_ball(99), {}});  // 2 again, then two that cannot be
    ASSERT_TRUE(client.listen_until([&] { return client.state.results.size() == 4; }));
    auto& results = client.state.results;
    EXPECT_EQ(results[1].code(), v1::INPUT_CODE_APPLIED);
    EXPECT_EQ(results[2].code(), v1::INPUT_CODE_APPLIED);
    EXPECT_EQ(results[3].code(), v1::INPUT_CODE_INVALID);
    EXPECT_NE(results[3].message().find("sphere.radius is 99"), std::string::npos);
    EXPECT_EQ(results[4].code(), v1::INPUT_CODE_INVALID);
    ASSERT_TRUE(
        client.listen_until([&] { return client.state.entities.contains(results[2].entity()); }));
    const auto owned = [&] {
        return std::ranges::count_if(client.state.entities, [&](const auto& entry) {
            return entry.second.owner() == client.state.client_id;
        });
    };
    EXPECT_EQ(owned(), 2);
    client.inputs(5, {removal(results[1].entity()), removal(results[1].entity()), removal(1)});
    ASSERT_TRUE(client.listen_until([&] { return results.size() == 7; }));
    EXPECT_EQ(results[5].code(), v1::INPUT_CODE_APPLIED);
    EXPECT_EQ(results[6].code(), v1::INPUT_CODE_NOT_FOUND);
    EXPECT_EQ(results[7].code(), v1::INPUT_CODE_NOT_ALLOWED) << "the scene's";
    ASSERT_TRUE(client.listen_until([&] { return owned() == 1; }));
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(ClientSessionTest, applies_scheduled_input_at_its_tick_and_reports_margin) {
    TestClient client(context);
    client.hello();
    ASSERT_TRUE(client.listen_until([&] { return client.state.snapshots > 5; }));
    v1::Input early = spawn_ball(0.2);
    const FramePtr now = worlds.find("")->frame();
    const std::uint32_t tick = now->tick + 8;
    early.set_tick(tick);
    client.inputs(1, {early});
    ASSERT_TRUE(client.listen_until([&] { return client.state.input_margin_us != 0; }));
    ASSERT_EQ(client.state.results.size(), 1u);
    EXPECT_EQ(client.state.results[1].tick(), tick);
    // It came seven to eight ticks before; those that a busy machine gave up meanwhile come on top.
    const std::uint32_t lost = worlds.find("")->frame()->late_ticks - now->late_ticks;
    EXPECT_GT(client.state.input_margin_us, 50'000);
    EXPECT_LT(client.state.input_margin_us, (8 + lost) * 16'667);
}

TEST_F(ClientSessionTest, removes_spawned_bodies_when_the_client_leaves) {
    TestClient leaver(context), stayer(context);
    leaver.hello();
    stayer.hello();
    leaver.inputs(1, {spawn_ball(0.3)});
    ASSERT_TRUE(leaver.listen_until([&] { return leaver.state.results.size() == 1; }));
    const std::uint32_t body = leaver.state.results[1].entity();
    ASSERT_TRUE(stayer.listen_until([&] { return stayer.state.entities.contains(body); }));
    v1::ClientMessage leave;
    leave.mutable_leave();
    leaver.send(leave);
    EXPECT_TRUE(leaver.session.end() && leaver.session.end()->ok());
    EXPECT_EQ(sessions.clients(), 1);
    EXPECT_TRUE(stayer.listen_until([&] { return !stayer.state.entities.contains(body); }));
    EXPECT_EQ(stayer.state.violations, 0) << stayer.state.first_violation;
}

TEST_F(ClientSessionTest, spectator_receives_snapshots_and_cannot_send_inputs) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { hello.set_spectator(true); });
    client.inputs(1, {spawn_ball(0.3)});
    ASSERT_TRUE(client.listen_until([&] { return client.state.results.size() == 1; }));
    EXPECT_EQ(client.state.results[1].code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_GT(client.state.snapshots, 0);
}

TEST_F(ClientSessionTest, sends_at_most_one_window_without_acks) {
    TestClient client(context);
    client.hello();
    // Four messages until the first is acknowledged, of which the welcome and the roster are two.
    // A single one follows, 0.15 s after the last one.
    ASSERT_TRUE(client.listen_until([&] { return client.state.snapshots == 2; }, false));
    const auto full = Clock::now();
    ASSERT_TRUE(client.listen_until([&] { return client.state.snapshots > 2; }, false));
    EXPECT_GT(Clock::now() - full, 100ms);
    EXPECT_EQ(client.state.snapshots, 3);
    EXPECT_EQ(client.state.welcome.ack_interval_ms(), 100u);
    client.ack(client.state.newest_frame);
    EXPECT_TRUE(client.listen_until([&] { return client.state.skipped > 0; }));
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(ClientSessionTest, sends_a_keyframe_on_request) {
    TestClient client(context);
    client.hello();
    ASSERT_TRUE(client.listen_until([&] { return client.state.snapshots > 3; }));
    const int before = client.state.keyframes;
    client.ack(client.state.newest_frame, true);
    EXPECT_TRUE(client.listen_until([&] { return client.state.keyframes == before + 1; }));
    ASSERT_TRUE(client.listen_until(
        [&, n = client.state.snapshots] { return client.state.snapshots > n + 3; }));
    EXPECT_EQ(client.state.keyframes, before + 1) << "one, then deltas again";
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(ClientSessionTest, rounds_requested_rate_down_to_a_divisor) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { hello.set_snapshot_hz(25); });
    client.listen();
    EXPECT_EQ(client.state.welcome.snapshot_hz(), 20u);
    std::set<std::uint32_t> phases;
    ASSERT_TRUE(client.listen_until([&] {
        if (client.state.snapshots > 1) phases.insert(client.state.newest_frame % 3);
        return client.state.snapshots > 6;
    }));
    EXPECT_EQ(phases, std::set<std::uint32_t>{0});
}

TEST_F(ClientSessionTest, answers_pings) {
    TestClient client(context);
    client.hello();
    v1::ClientMessage ping;
    ping.mutable_ping()->set_client_time_us(42);
    client.send(ping);
    client.listen();
    EXPECT_EQ(client.state.pongs, 1);
}

TEST_F(ClientSessionTest, rejects_invalid_clients_with_a_notice) {
    struct Case {
        const char* what;
        std::function<void(TestClient&)> misbehave;
        ErrorCode code;
    };
    v1::ClientMessage second_hello;
    second_hello.mutable_hello()->set_protocol(1);
    const Case cases[] = {
        {"protocol", [](TestClient& c) { c.hello([](v1::Hello& h) { h.set_protocol(2); }); },
         ErrorCode::failed_precondition},
        {"world", [](TestClient& c) { c.hello([](v1::Hello& h) { h.set_world("nowhere"); }); },
         ErrorCode::not_found},
        {"ticket", [](TestClient& c) { c.hello([](v1::Hello& h) { h.set_ticket("forged"); }); },
         ErrorCode::unauthenticated},
        {"ack before hello", [](TestClient& c) { c.ack(1); }, ErrorCode::failed_precondition},
        {"garbage", [](TestClient& c) { c.session.receive("\xff\xff", Clock::now()); },
         ErrorCode::invalid_argument},
        {"size", [](TestClient& c) { c.session.receive(std::string(70000, 'x'), Clock::now()); },
         ErrorCode::resource_exhausted},
        {"second hello",
         [&](TestClient& c) {
             c.hello();
             c.send(second_hello);
         },
         ErrorCode::failed_precondition},
        {"batch",
         [](TestClient& c) {
             c.hello();
             c.inputs(1, std::vector<v1::Input>(65));
         },
         ErrorCode::invalid_argument},
    };
    for (const Case& c : cases) {
        TestClient client(context);
        c.misbehave(client);
        ASSERT_TRUE(client.session.end() && !client.session.end()->ok()) << c.what;
        EXPECT_EQ(client.session.end()->error().code, c.code) << c.what;
        client.listen();
        ASSERT_FALSE(client.state.notices.empty()) << c.what;
        EXPECT_EQ(client.state.notices.back().code(), v1::NOTICE_CODE_REFUSED) << c.what;
        EXPECT_EQ(client.state.notices.back().message(), client.session.end()->error().message)
            << c.what;
    }
    EXPECT_EQ(sessions.clients(), 0);
}

TEST_F(ClientSessionTest, rejects_clients_when_full) {
    TestClient one(context), two(context), three(context);
    one.hello();
    two.hello();
    three.hello();
    ASSERT_TRUE(three.session.end() && !three.session.end()->ok());
    EXPECT_EQ(three.session.end()->error().code, ErrorCode::resource_exhausted);
    one.session.on_peer_closed(Clock::now());
    TestClient four(context);
    four.hello();
    EXPECT_FALSE(four.session.end());
}

TEST_F(ClientSessionTest, disconnects_silent_clients) {
    TestClient mute(context), quiet(context);
    quiet.hello();
    mute.stay_silent(0s, 4s);
    EXPECT_FALSE(mute.session.end());
    mute.stay_silent(4s, 6s);
    ASSERT_TRUE(mute.session.end() && !mute.session.end()->ok());
    EXPECT_EQ(mute.session.end()->error().code, ErrorCode::deadline_exceeded);
    quiet.stay_silent(0s, 9s);
    EXPECT_FALSE(quiet.session.end());
    for (Clock::duration later = 9s; later <= 11s; later += 100ms)
        quiet.session.wait_for_write(Clock::now() + later);  // it does not read either
    ASSERT_TRUE(quiet.session.end() && !quiet.session.end()->ok());
    EXPECT_EQ(quiet.session.end()->error().code, ErrorCode::deadline_exceeded);
}

TEST_F(ClientSessionTest, process_stall_does_not_time_out_clients) {
    TestClient mute(context), quiet(context);
    quiet.hello();
    for (TestClient* client : {&mute, &quiet}) {
        client->listen(12s);  // the first look after 12 s
        EXPECT_FALSE(client->session.end());
        client->stay_silent(12s, 15s);
        EXPECT_FALSE(client->session.end());
    }
    quiet.stay_silent(15s, 23s);
    ASSERT_TRUE(quiet.session.end() && !quiet.session.end()->ok());
    EXPECT_EQ(quiet.session.end()->error().code, ErrorCode::deadline_exceeded);
}

TEST_F(ClientSessionTest, drops_excess_messages_then_disconnects) {
    TestClient client(context);
    client.hello();
    const Clock::time_point now = Clock::now();
    const std::string message = client.ack_bytes();
    for (int i = 0; i < 200; ++i) client.session.receive(message, now);
    EXPECT_FALSE(client.session.end());
    client.listen();
    ASSERT_EQ(client.state.notices.size(), 1u) << "told once";
    EXPECT_EQ(client.state.notices[0].code(), v1::NOTICE_CODE_RATE_LIMIT);
    for (int i = 0; i < 1200; ++i) client.session.receive(message, now);
    ASSERT_TRUE(client.session.end() && !client.session.end()->ok());
    EXPECT_EQ(client.session.end()->error().code, ErrorCode::resource_exhausted);
}

TEST_F(ClientSessionTest, one_ack_per_snapshot_is_not_rate_limited) {
    scenes::SceneDescription fast = *scenes::find_scene("stack");
    fast.name = "fast";
    fast.hz = 240;
    ASSERT_TRUE(worlds.create("", fast).ok());
    TestClient client(context);
    client.hello([](v1::Hello& hello) { hello.set_world("fast"); });
    const Clock::time_point now = Clock::now();
    for (int i = 0; i < 300; ++i) client.session.receive(client.ack_bytes(), now);
    client.listen();
    EXPECT_TRUE(client.state.notices.empty()) << client.state.notices[0].message();
}

TEST_F(ClientSessionTest, disconnects_clients_that_do_not_read_replies) {
    TestClient client(context);
    client.hello();
    v1::ClientMessage ping;
    ping.mutable_ping();
    for (int second = 0; second < 9 && !client.session.end(); ++second) {
        for (int i = 0; i < 80; ++i) client.send(ping, std::chrono::seconds(second));
        client.session.wait_for_write(Clock::now() + std::chrono::seconds(second));
    }
    ASSERT_TRUE(client.session.end() && !client.session.end()->ok());
    EXPECT_EQ(client.session.end()->error().code, ErrorCode::resource_exhausted);
}

TEST_F(ClientSessionTest, notifies_clients_of_drain_and_shutdown) {
    TestClient client(context), late(context);
    client.hello();
    context.draining = true;
    late.hello();
    ASSERT_TRUE(late.session.end() && !late.session.end()->ok());
    EXPECT_EQ(late.session.end()->error().code, ErrorCode::unavailable);
    client.listen();
    EXPECT_FALSE(client.session.end()) << "may go on until the drain is over";
    ASSERT_EQ(client.state.notices.size(), 1u);
    EXPECT_EQ(client.state.notices[0].code(), v1::NOTICE_CODE_DRAINING);
    context.closing = true;
    client.listen();
    ASSERT_TRUE(client.session.end() && !client.session.end()->ok());
    EXPECT_EQ(client.session.end()->error().code, ErrorCode::unavailable);
}

TEST_F(ClientSessionTest, deleting_a_world_ends_its_sessions) {
    TestClient client(context);
    client.hello();
    client.listen();
    worlds.remove("stack");
    client.listen();
    ASSERT_TRUE(client.session.end() && !client.session.end()->ok());
    EXPECT_EQ(client.session.end()->error().code, ErrorCode::aborted);
    EXPECT_EQ(client.state.notices.back().code(), v1::NOTICE_CODE_WORLD_CLOSED);
}

// --- events ---

// A floor of entity 1, a gate of entity 2 above it and a ball of entity 3 that falls through it.
constexpr const char* gate_scene = R"({
  "name": "gate", "bodies": [
    {"name": "floor", "type": "BODY_TYPE_STATIC", "shapes": [{"plane": {}}]},
    {"name": "gate", "type": "BODY_TYPE_STATIC", "position": {"y": 3},
     "shapes": [{"box": {"halfExtents": {"x": 1, "y": 0.5, "z": 1}}, "trigger": true}]},
    {"name": "ball", "position": {"y": 6}, "maySleep": false, "shapes": [{"sphere": {"radius": 0.5}, "reportStays": true}]}]})";

class EventsTest : public ClientSessionTest {
protected:
    void add_gate(double hz = 60) {
        scenes::SceneDescription scene = *scenes::read_scene_json(gate_scene);
        scene.hz = hz;
        ASSERT_TRUE(worlds.create("", scene).ok());
    }
    static void ask_for_events(v1::Hello& hello) {
        hello.set_world("gate");
        hello.set_events(true);
    }
};

TEST_F(EventsTest, reports_trigger_and_contact_events_once_and_in_order) {
    add_gate();
    TestClient client(context), deaf(context);
    client.hello(ask_for_events);
    deaf.hello([](v1::Hello& hello) { hello.set_world("gate"); });
    const auto& events = client.state.events;
    ASSERT_TRUE(client.listen_until([&] {
        deaf.listen();
        deaf.ack(deaf.state.newest_frame);
        return !events.empty() && events.back().contacts_size() > 0 && events.size() > 25;
    }));
    std::vector<std::string> story;
    std::uint32_t entered = 0, left = 0;
    int stayed = 0;
    const auto tell = [&](const char* what, std::uint32_t a, std::uint32_t b) {
        story.push_back(what + std::string(" ") + std::to_string(a) + " " + std::to_string(b));
    };
    for (const v1::Events& tick : events) {
        EXPECT_EQ(tick.missed(), 0u);
        for (const auto& t : tick.triggers_entered()) {
            tell("enter", t.trigger(), t.entity());
            entered = tick.tick();
        }
        stayed += tick.triggers_stayed_size();
        for (const auto& t : tick.triggers_left()) {
            tell("left", t.trigger(), t.entity());
            left = tick.tick();
        }
        for (const auto& c : tick.contacts_began())
            tell("touch", std::min(c.entity_a(), c.entity_b()),
                 std::max(c.entity_a(), c.entity_b()));
    }
    EXPECT_EQ(story, (std::vector<std::string>{"enter 2 3", "left 2 3", "touch 1 3"}));
    EXPECT_EQ(stayed, static_cast<int>(left - entered) - 1) << "in each tick between the two";
    // From 6 m: in the gate between 4 and 2 m, (sqrt(8) - sqrt(4)) / sqrt(g) seconds.
    EXPECT_NEAR(left - entered, (std::sqrt(8.0) - std::sqrt(4.0)) / std::sqrt(9.81) * 60, 1.5);
    const auto& press = events.back().contacts(0);
    EXPECT_GT(press.impulse(), 0);
    EXPECT_NEAR(std::abs(press.normal().y()), 1, 1e-3);
    EXPECT_EQ(client.state.violations + deaf.state.violations, 0)
        << client.state.first_violation << deaf.state.first_violation;
}

TEST_F(EventsTest, slow_client_receives_the_count_of_missed_event_ticks) {
    add_gate(240);  // the ball lies on the floor after a quarter of a thousand ticks and presses
    TestClient slow(context), quick(context);
    slow.hello(ask_for_events);
    quick.hello(ask_for_events);
    const auto& events = slow.state.events;
    ASSERT_TRUE(quick.listen_until([&] {
        slow.listen();
        slow.ack(slow.state.newest_frame);
        return !events.empty() && events.back().contacts_size() > 0;
    }));
    const std::uint32_t before = events.back().tick();
    const std::size_t told = events.size();
    // It does not read for a while. Meanwhile the other one hears of every tick.
    const auto world = worlds.find("gate");
    ASSERT_TRUE(quick.listen_until([&] { return world->frame()->tick > before + 150; }));
    slow.ack(slow.state.newest_frame);
    ASSERT_TRUE(slow.listen_until([&] { return events.size() > told + 80; }));
    const v1::Events& next = events[told];
    EXPECT_GT(next.missed(), 50u) << "150 ticks and a queue of 64";
    EXPECT_EQ(next.missed(), next.tick() - before - 1) << "something happened in every tick";
    for (std::size_t i = told + 1; i < events.size(); i++) {
        EXPECT_EQ(events[i].missed(), 0u);
        EXPECT_EQ(events[i].tick(), events[i - 1].tick() + 1);
    }
    for (const v1::Events& tick : quick.state.events) EXPECT_EQ(tick.missed(), 0u);
    EXPECT_EQ(slow.state.violations + quick.state.violations, 0)
        << slow.state.first_violation << quick.state.first_violation;
}

TEST_F(EventsTest, reduced_rate_client_receives_events_of_every_tick) {
    add_gate();
    TestClient client(context);
    client.hello([](v1::Hello& hello) {
        ask_for_events(hello);
        hello.set_snapshot_hz(6);
    });
    const auto& events = client.state.events;
    ASSERT_TRUE(client.listen_until([&] { return events.size() > 40; }));
    for (const v1::Events& tick : events) EXPECT_EQ(tick.missed(), 0u);
    EXPECT_LT(client.state.snapshots, 20);
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(EventsTest, stops_copying_events_after_the_last_listener_leaves) {
    add_gate();
    const auto world = worlds.find("gate");
    {
        TestClient client(context);
        client.hello(ask_for_events);
        ASSERT_TRUE(client.listen_until([&] { return client.state.events.size() > 3; }));
        EXPECT_FALSE(world->frame()->events->ticks.empty());
    }
    const std::uint32_t tick = world->frame()->tick;
    TestClient clock(context);
    clock.hello();
    ASSERT_TRUE(clock.listen_until([&] { return world->frame()->tick > tick + 3; }));
    EXPECT_TRUE(world->frame()->events->ticks.empty());
}

// A row of 40 balls that roll, ten metres apart.
class InterestTest : public ClientSessionTest {
protected:
    void SetUp() override {
        scenes::SceneDescription row = *scenes::read_scene_json(
            R"({"name": "row", "bodies": [{"type": "BODY_TYPE_STATIC", "shapes": [{"plane": {}}]}]})");
        for (int k = 0; k < 40; k++) {
            scenes::SceneBody roller;
            roller.body = {.pose = {{10.0 * k, 0.5, 0}, {}}, .linear_velocity = {0, 0, 0.5}};
            roller.shapes = {{.geometry = physics::Sphere{0.5}}};
            row.bodies.push_back(roller);
        }
        ASSERT_TRUE(worlds.create("", row).ok());
    }
    static void see(v1::Interest& interest, double x, double radius) {
        interest.mutable_focus()->set_x(x);
        interest.set_radius(radius);
    }
    // The balls that the client sees, by number.
    static std::set<int> balls(const TestClient& client) {
        std::set<int> seen;
        if (const auto* newest = client.state.newest())
            for (const auto& entity : newest->entities)
                if (entity.id > 1) seen.insert(static_cast<int>(entity.id) - 2);
        return seen;
    }
};

TEST_F(InterestTest, sends_entities_within_interest_and_the_ground) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { see(*hello.mutable_interest(), 16, 40); });
    // Cells of 32 m: those that begin within 40 m of x = 16 end at x = 64.
    ASSERT_TRUE(client.listen_until([&] { return balls(client).size() >= 7; }));
    EXPECT_TRUE(client.state.welcome.cells());
    EXPECT_EQ(balls(client), (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(client.state.entities.contains(1)) << "the ground is seen from everywhere";
    EXPECT_EQ(client.state.entities.size(), 8u) << "nobody told it of the others";
    v1::ClientMessage look;
    see(*look.mutable_interest(), 300, 40);
    client.send(look);
    ASSERT_TRUE(client.listen_until([&] { return !balls(client).contains(0); }));
    ASSERT_TRUE(client.listen_until([&] { return balls(client).contains(31); }));
    EXPECT_FALSE(balls(client).contains(5));
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(InterestTest, byte_budget_limits_all_traffic) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { hello.set_max_kbps(40); });
    ASSERT_TRUE(client.listen_until([&] { return balls(client).size() == 40; }))
        << "it comes to know all of the world";
    const std::size_t before = client.bytes_taken;
    const auto begun = Clock::now();
    ASSERT_TRUE(client.listen_until([&] { return Clock::now() - begun > 1s; }));
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    const double kbps = static_cast<double>(client.bytes_taken - before) * 8e-3 / seconds;
    EXPECT_LE(kbps, 42 + 40 * 0.05);
    EXPECT_GE(kbps, 20) << "forty balls that roll want more than that";
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(InterestTest, removes_entities_within_interest) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { see(*hello.mutable_interest(), 16, 40); });
    ASSERT_TRUE(client.listen_until([&] { return balls(client).size() >= 7; }));
    std::uint32_t sequence = 1;
    for (int round = 0; round < 3; round++) {
        client.inputs(sequence++, {spawn_ball(0.3)});
        ASSERT_TRUE(client.listen_until([&] { return client.state.entities.size() == 9; }));
        const std::uint32_t spawned = client.state.entities.rbegin()->first;
        client.inputs(sequence++, {removal(spawned)});
        ASSERT_TRUE(client.listen_until([&] { return client.state.removed.contains(spawned); }));
        const int so_far = client.state.snapshots;
        ASSERT_TRUE(client.listen_until([&] { return client.state.snapshots > so_far + 5; }));
    }
    EXPECT_TRUE(client.state.notices.empty()) << client.state.notices[0].message();
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(InterestTest, resends_every_cell_as_keyframe_on_request) {
    TestClient client(context);
    client.hello([](v1::Hello& hello) { see(*hello.mutable_interest(), 16, 40); });
    ASSERT_TRUE(client.listen_until([&] { return balls(client).size() >= 7; }));
    client.ack(client.state.newest_frame, true);
    client.state.cells.clear();
    EXPECT_TRUE(client.listen_until([&] { return client.state.cells.size() >= 3; }))
        << "the ground's cell too, which does not move";
    EXPECT_TRUE(client.listen_until([&] { return balls(client).size() >= 7; }));
    EXPECT_EQ(client.state.violations, 0) << client.state.first_violation;
}

TEST_F(InterestTest, ignores_absent_interest_and_rejects_invalid_interest) {
    TestClient client(context);
    client.hello();
    v1::ClientMessage look;
    see(*look.mutable_interest(), 300, 40);
    client.send(look);
    client.listen();
    ASSERT_EQ(client.state.notices.size(), 1u);
    EXPECT_EQ(client.state.notices[0].message(),
              "interest: the stream has no area of interest; set hello.interest");
    TestClient other(context);
    other.hello([](v1::Hello& hello) { see(*hello.mutable_interest(), 0, -3); });
    other.listen();
    ASSERT_EQ(other.state.notices.size(), 1u);
    EXPECT_EQ(
        other.state.notices[0].message(),
        "hello.interest.radius is out of range; it must be 0 (the whole world) or at least 1 m");
}

TEST_F(ClientSessionTest, rejects_disallowed_shapes_and_lists_allowed_ones) {
    TestClient client(context);
    client.hello();
    v1::Input mesh, points;
    mesh.mutable_spawn()->mutable_shape()->mutable_mesh();
    for (int i = 0; i < 40; i++)
        points.mutable_spawn()->mutable_shape()->mutable_hull()->add_points();
    v1::Input cone = spawn_ball(1);
    cone.mutable_spawn()->mutable_shape()->mutable_cone()->set_radius(0.3);
    cone.mutable_spawn()->mutable_shape()->mutable_cone()->set_half_length(0.4);
    client.inputs(1, {mesh, points, cone});
    ASSERT_TRUE(client.listen_until([&] { return client.state.results.size() == 3; }));
    EXPECT_EQ(client.state.results[1].message(),
              std::string("spawn.shape is a mesh; ") + spawned_shapes_allowed);
    EXPECT_EQ(client.state.results[2].message(),
              std::string("spawn.shape.hull.points has 40 entries; ") + spawned_shapes_allowed);
    EXPECT_EQ(client.state.results[3].code(), v1::INPUT_CODE_APPLIED)
        << client.state.results[3].message();
}

TEST_F(ClientSessionTest, ticket_joins_its_world_once) {
    ASSERT_TRUE(worlds.create("second", *scenes::find_scene("dominoes")).ok());
    const std::string ticket =
        authorizer
            ->issue_ticket({.subject = "ann", .role = Role::player, .anonymous = false}, "w2",
                           "127.0.0.1")
            .value();
    TestClient client(context), thief(context);
    client.hello([&](v1::Hello& hello) { hello.set_ticket(ticket); });
    client.listen();
    EXPECT_EQ(client.state.welcome.world_name(), "second");
    thief.hello([&](v1::Hello& hello) { hello.set_ticket(ticket); });
    ASSERT_TRUE(thief.session.end() && !thief.session.end()->ok());
    EXPECT_EQ(thief.session.end()->error().code, ErrorCode::unauthenticated);
}

}  // namespace
}  // namespace jostle::server
