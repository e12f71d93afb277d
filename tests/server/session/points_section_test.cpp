// SPDX-License-Identifier: MIT
//
// Point objects from a module of a hosted world to a client, with and without a byte budget.
#include "server/session/points_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jostle/scenes/catalog.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"
#include "tests/support/waving_module.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;
using test::Waving;

class PointsSectionTest : public testing::Test {
protected:
    std::shared_ptr<WorldHost> host(double sheets, double still_after = 0) {
        test::register_waving();
        scenes::SceneDescription scene = test::small_scene();
        scene.modules.push_back(
            {.tag = "waving", .settings = {{"sheets", sheets}, {"still_after", still_after}}});
        const std::shared_ptr<WorldHost> world = server.host(scene);
        first_tick = world->frame()->tick;
        return world;
    }
    // Steps of the world up to the last tick in which the module published.
    std::uint32_t published_steps(const WorldHost& world) const {
        const std::uint32_t tick = world.frame()->tick;
        return tick - (tick - 1) % Waving::divisor - first_tick;
    }
    // Largest distance of a received point of the first sheet from the sheet after `steps` steps.
    static double error_of(const SessionHarness& player, std::uint32_t steps) {
        Waving reference;
        reference.steps = steps;
        const auto& objects = player.conversation.view().points().objects();
        if (objects.empty()) return 1e9;
        const auto& object = objects.begin()->second;
        const auto received = object.newest();
        const auto expected = reference.sheet(object.description().key());
        if (received.size() != expected.size()) return 1e9;
        double most = 0;
        for (std::size_t k = 0; k < expected.size(); k++)
            most = std::max(
                most, std::hypot(received[k][0] - expected[k].x, received[k][1] - expected[k].y,
                                 received[k][2] - expected[k].z));
        return most;
    }
    static std::size_t levels(const SessionHarness& player) {
        return player.conversation.view()
            .points()
            .objects()
            .begin()
            ->second.history()
            .states()
            .back()
            .points.levels;
    }

    TestServer server;
    std::uint32_t first_tick = 0;  // of the frame before the first step
};

TEST_F(PointsSectionTest, every_point_arrives_within_half_a_step) {
    const auto world = host(2);
    SessionHarness player(server, {.channels = {"waving"}}), other(server, {});
    int compared = 0;
    test::play(server, *world, {&player, &other}, 120, [&](int tick) {
        if (tick < 10) return;
        EXPECT_LT(error_of(player, published_steps(*world)), 0.002);
        compared++;
    });
    EXPECT_GT(compared, 30);
    EXPECT_EQ(player.conversation.view().points().objects().size(), 2u);
    EXPECT_TRUE(other.conversation.view().points().objects().empty());
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

// The rendered wave moves steadily, although states arrive every third tick.
TEST_F(PointsSectionTest, rendered_points_move_smoothly) {
    const auto world = host(1);
    SessionHarness player(server, {.channels = {"points:*"}});
    std::vector<double> heights;
    test::play(server, *world, {&player}, 180, [&](int tick) {
        player.draw();
        const auto objects = player.conversation.interpolated_points();
        if (tick < 60 || objects.empty()) return;
        heights.push_back(objects[0].positions[Waving::columns - 1][2]);
    });
    ASSERT_GT(heights.size(), 100u);
    for (std::size_t k = 2; k < heights.size(); k++)
        EXPECT_NEAR(heights[k] - 2 * heights[k - 1] + heights[k - 2], 0, 0.012)
            << "m per tick^2; the wave itself has 0.002";
}

// 2900 drops, 160 balls and a rope, which take 550 kbit/s without a limit.
TEST_F(PointsSectionTest, fountain_fits_100_kbit_per_second) {
    const auto world = server.host(*scenes::find_scene("fountain"));
    SessionHarness player(server, {.channels = {"points:*"}, .max_kbps = 100});
    test::play(server, *world, {&player}, 300);
    const auto before = player.conversation.stats().bytes_received;
    test::play(server, *world, {&player}, 120);
    const double kbps =
        8e-3 * static_cast<double>(player.conversation.stats().bytes_received - before) / 2;
    EXPECT_LT(kbps, 106);
    const auto& objects = player.conversation.view().points().objects();
    ASSERT_EQ(objects.size(), 3u);
    for (const auto& [id, object] : objects)
        EXPECT_GT(object.history().states().back().tick + 20, world->frame()->tick)
            << "object " << id << " is at most a third of a second old";
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

TEST_F(PointsSectionTest, nothing_is_published_without_a_subscriber) {
    const auto world = host(1);
    SessionHarness other(server, {});
    test::play(server, *world, {&other}, 10);
    EXPECT_TRUE(world->frame()->points->empty());
    EXPECT_EQ(world->listeners().points, 0);
}

TEST_F(PointsSectionTest, object_at_rest_costs_nothing) {
    const auto world = host(1, 30);
    SessionHarness player(server, {.channels = {"waving"}}), other(server, {});
    test::play(server, *world, {&player, &other}, 60);
    const auto received = [&] {
        return static_cast<double>(player.conversation.stats().bytes_received) -
               static_cast<double>(other.conversation.stats().bytes_received);
    };
    const double before = received();
    test::play(server, *world, {&player, &other}, 60);
    EXPECT_NEAR(received(), before, 64);
    EXPECT_LT(error_of(player, 30), 0.002);
}

TEST_F(PointsSectionTest, budget_limits_the_rate_and_coarse_levels_stay_close) {
    const auto world = host(1);
    SessionHarness player(server, {.channels = {"waving"}, .max_kbps = 50});
    test::play(server, *world, {&player}, 120);
    const auto before = player.conversation.stats().bytes_received;
    double most = 0;
    test::play(server, *world, {&player}, 300,
               [&](int) { most = std::max(most, error_of(player, published_steps(*world))); });
    const double kbps =
        8e-3 * static_cast<double>(player.conversation.stats().bytes_received - before) / 5;
    EXPECT_LT(kbps, 52);
    EXPECT_GT(kbps, 15);
    EXPECT_LT(most, 0.2) << "a sheet of 1.4 m";
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

TEST_F(PointsSectionTest, object_that_stops_is_refined_to_its_last_point) {
    const auto world = host(1, 200);
    SessionHarness player(server, {.channels = {"waving"}, .max_kbps = 16});
    test::play(server, *world, {&player}, 190);
    EXPECT_LT(levels(player), snapshot::point_levels);
    test::play(server, *world, {&player}, 120);
    EXPECT_EQ(levels(player), snapshot::point_levels);
    EXPECT_LT(error_of(player, 200), 0.002);
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

TEST_F(PointsSectionTest, moving_bodies_and_objects_share_the_budget) {
    const auto world = host(4);
    SessionHarness player(server, {.channels = {"waving"}, .max_kbps = 32});
    test::play(server, *world, {&player}, 300);
    const auto& objects = player.conversation.view().points().objects();
    ASSERT_EQ(objects.size(), 4u);
    for (const auto& [id, object] : objects)
        EXPECT_GT(object.history().states().back().tick + 30, world->frame()->tick)
            << "object " << id << " is at most half a second old";
    EXPECT_FALSE(player.conversation.view().frame().entities.empty());
}

TEST_F(PointsSectionTest, objects_outside_the_area_of_interest_end) {
    const auto world = host(4);  // at x = 0, 20, 40 and 60
    client::AreaOfInterest near{.radius = 25};
    SessionHarness player(server, {.channels = {"waving"}, .interest = near});
    test::play(server, *world, {&player}, 60);
    EXPECT_EQ(player.conversation.view().points().objects().size(), 2u);
    near.x = 60;
    player.conversation.set_interest(near);
    test::play(server, *world, {&player}, 60);
    const auto& objects = player.conversation.view().points().objects();
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects.begin()->second.description().key(), 3u);
}

TEST_F(PointsSectionTest, client_that_lost_a_message_receives_keyframes) {
    const auto world = host(1);
    SessionHarness player(server, {.channels = {"waving"}});
    test::play(server, *world, {&player}, 30);
    player.tamper = [&](std::string& bytes) {
        if (bytes.size() > 60) bytes[bytes.size() - 2] ^= 1;  // in the CRC of the points
    };
    test::play(server, *world, {&player}, 4);
    player.tamper = nullptr;
    test::play(server, *world, {&player}, 60);
    EXPECT_GT(player.conversation.stats().decode_errors, 0u);
    EXPECT_FALSE(player.conversation.view().points().needs_keyframe());
    EXPECT_LT(error_of(player, published_steps(*world)), 0.002);
}

}  // namespace
}  // namespace jostle::server
