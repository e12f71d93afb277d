// SPDX-License-Identifier: MIT
//
// A server that makes its links worse on purpose: what its clients see of it.
#include "server/session/session_network_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

Config with_link(const std::string& session, std::vector<std::string> worlds = {}) {
    Config config;
    config.development = {session, std::move(worlds)};
    EXPECT_TRUE(check(config).ok());
    return config;
}

struct Ages {
    double median_ms = 0, greatest_ms = 0, round_trip_ms = 0;
    std::uint64_t snapshots = 0;
};

// Of ten seconds of a world that moves.
Ages ages_of(const Config& config) {
    TestServer server(config);
    scenes::SceneDescription scene = test::small_scene();
    scene.world.gravity = {};
    scene.bodies[3].body.angular_velocity = {1, 2, 3};
    scene.bodies[3].body.sleep_allowed = false;
    const auto world = server.host(scene);
    SessionHarness player(server, {.name = "player"});
    test::play(server, *world, {&player}, 600);
    std::vector<float> ages = player.conversation.take_ages_ms();
    EXPECT_GT(ages.size(), 100u);
    std::ranges::sort(ages);
    return {.median_ms = ages[ages.size() / 2],
            .greatest_ms = ages.back(),
            .round_trip_ms = player.conversation.stats().rtt_ms,
            .snapshots = player.conversation.stats().snapshots};
}

TEST(SessionNetworkSimulator, delay_of_100_ms_adds_100_ms_to_snapshot_age) {
    const Ages plain = ages_of(Config()), delayed = ages_of(with_link("latency_ms=100"));
    EXPECT_NEAR(delayed.median_ms - plain.median_ms, 100, 6);
    EXPECT_NEAR(delayed.round_trip_ms - plain.round_trip_ms, 200, 10) << "both ways";
    EXPECT_GT(delayed.snapshots, plain.snapshots * 9 / 10) << "the rate is the same";
}

TEST(SessionNetworkSimulator, stall_delays_messages_without_loss) {
    const Ages stalled = ages_of(with_link("stall_ms=400,stall_interval_ms=2000,seed=2"));
    EXPECT_GT(stalled.greatest_ms, 300);
    EXPECT_LT(stalled.median_ms, 20);
}

TEST(SessionNetworkSimulator, jitter_preserves_message_order) {
    const Ages jittery = ages_of(with_link("jitter_ms=40,jitter_tail_ms=10"));
    EXPECT_GT(jittery.median_ms, 15);
    EXPECT_LT(jittery.median_ms, 60);
}

TEST(SessionNetworkSimulator, applies_only_to_configured_worlds) {
    const std::string session = "latency_ms=5";
    EXPECT_TRUE(make_network_simulator({session, {}}, "yard", 1));
    EXPECT_TRUE(make_network_simulator({session, {"lab", "yard"}}, "yard", 1));
    EXPECT_FALSE(make_network_simulator({session, {"lab"}}, "yard", 1));
    EXPECT_FALSE(make_network_simulator({"", {}}, "yard", 1)) << "off by itself";
}

TEST(SessionNetworkSimulator, rejects_invalid_settings_at_startup) {
    Config config;
    config.development.network_conditions = "latency_ms=soon";
    const Status refused = check(config);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message,
              "development.network_conditions: network condition 'latency_ms=soon': must be a "
              "number from 0 to 60000");
}

TEST(SessionNetworkSimulator, delivers_leave_message_before_disconnect) {
    TestServer server(with_link("latency_ms=500"));
    const auto world = server.host(test::small_scene());
    SessionHarness player(server, {.name = "player"});
    test::play(server, *world, {&player}, 120);
    player.conversation.leave();
    player.exchange();
    player.session->on_peer_closed(server.now);
    EXPECT_EQ(server.sessions.clients(), 0);
    EXPECT_EQ(server.context.resume_registry.disconnected(), 0u);
}

}  // namespace
}  // namespace jostle::server
