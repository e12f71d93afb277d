// SPDX-License-Identifier: MIT
//
// Who simulates may ask how bodies move, beside where they are; nobody else pays for it.
#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "server/world/module_channels.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

physics::Vec3 sent_velocity(const SessionHarness& player, EntityId id) {
    const auto told = player.conversation.view().channel(motion_kind, id);
    if (told.size() != 6) return {99, 99, 99};
    return physics::Vec3{told[0] / velocity_units, told[1] / velocity_units,
                         told[2] / velocity_units};
}

// Every body that is awake, in each of thirty frames: how far it went is how fast it was.
TEST(MotionChannel, matches_body_displacements) {
    TestServer server;
    const auto world = server.host(test::small_scene());
    SessionHarness player(server, {.channels = {motion_kind}});
    SessionHarness other(server, {.channels = {"*"}}), silent(server, {});
    test::play(server, *world, {&player, &other, &silent}, 20);
    int compared = 0, off = 0;
    FramePtr before = world->frame();
    test::play(server, *world, {&player, &other, &silent}, 30, [&](int) {
        const FramePtr now = world->frame();
        for (const EntityPose& body : now->entities) {
            const auto was = std::ranges::find(before->entities, body.id, &EntityPose::id);
            if (!body.awake || was == before->entities.end()) continue;
            const physics::Vec3 went = (body.pose.position - was->pose.position) * 60.0;
            off += length(went - sent_velocity(player, body.id)) < 0.2 ? 0 : 1;
            compared++;
        }
        before = now;
    });
    EXPECT_GT(compared, 40);
    EXPECT_LE(off, 1) << "but in the tick in which the ball lands";
    EXPECT_TRUE(other.conversation.view().channels().empty()) << "all kinds are those of modules";
    EXPECT_TRUE(silent.conversation.view().channels().empty());
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

// 901 cubes that a big one draws along, for five seconds.
TEST(MotionChannel, uses_less_than_8_bytes_per_moving_body) {
    TestServer server({.world = {.bodies_max = 2000}});
    const auto world = server.host(*scenes::find_scene("katamari"));
    SessionHarness player(server, {.channels = {motion_kind}}), silent(server, {});
    std::size_t bodies = 0;
    test::play(server, *world, {&player, &silent}, 60);
    const auto before =
        player.conversation.stats().bytes_received - silent.conversation.stats().bytes_received;
    const auto poses_before = silent.conversation.stats().bytes_received;
    test::play(server, *world, {&player, &silent}, 300,
               [&](int) { bodies += world->frame()->awake; });
    const auto more = player.conversation.stats().bytes_received -
                      silent.conversation.stats().bytes_received - before;
    const auto poses = silent.conversation.stats().bytes_received - poses_before;
    const double each = static_cast<double>(more) / static_cast<double>(bodies);
    RecordProperty("bytes_each", std::to_string(each));
    RecordProperty("bytes_of_poses", std::to_string(poses));
    RecordProperty("bodies", std::to_string(bodies));
    EXPECT_GT(bodies, 3000u);
    EXPECT_LT(each, 8);
}

TEST(MotionChannel, stops_after_the_last_subscriber_leaves) {
    TestServer server;
    const auto world = server.host(test::small_scene());
    std::optional<SessionHarness> player(std::in_place, server,
                                         client::ClientOptions{.channels = {motion_kind}});
    test::play(server, *world, {&*player}, 5);
    EXPECT_FALSE(world->frame()->channels->empty());
    player.reset();
    test::play(server, *world, {}, 2);
    EXPECT_TRUE(world->frame()->channels->empty());
}

TEST(MotionChannel, is_not_sent_with_area_of_interest) {
    TestServer server;
    const auto world = server.host(test::small_scene());
    SessionHarness player(server, {.channels = {motion_kind}, .max_kbps = 500});
    test::play(server, *world, {&player}, 20);
    EXPECT_GT(player.conversation.stats().snapshots, 5u);
    EXPECT_TRUE(world->frame()->channels->empty());
}

}  // namespace
}  // namespace jostle::server
