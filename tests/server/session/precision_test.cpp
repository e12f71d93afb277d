// SPDX-License-Identifier: MIT
//
// Streams in a guaranteed precision, through a real session and the client library.
#include "jostle/snapshot/precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "jostle/scenes/catalog.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

constexpr client::Precision fine{.position = 0.01, .rotation = 0.001};

// Poses in the client's newest frame that differ from those of the server by more than allowed.
int misses(const SessionHarness& player, const Frame& frame, const snapshot::Precision& most) {
    int missed = 0;
    const client::WorldView& view = player.conversation.view();
    for (const snapshot::EntityState& state : view.frame().entities) {
        const auto truth = std::ranges::find(frame.entities, state.id, &EntityPose::id);
        const physics::Vec3& p = truth->pose.position;
        const physics::Quat& q = truth->pose.rotation;
        missed +=
            !snapshot::is_within(most, state, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, view.spec());
    }
    return missed;
}

TEST(Precision, asteroids_take_at_most_8_kB_per_second_within_a_centimetre_and_a_milliradian) {
    TestServer server;
    const auto world = server.host(*scenes::find_scene("asteroids"));
    SessionHarness player(server, {.snapshot_hz = 30, .precision = fine});
    test::play(server, *world, {&player}, 60);
    const auto before = player.conversation.stats().bytes_received;
    int missed = 0, compared = 0;
    constexpr int seconds = 10;
    test::play(server, *world, {&player}, 60 * seconds, [&](int) {
        const FramePtr now = world->frame();
        if (player.conversation.view().frame().frame != now->tick) return;
        missed += misses(player, *now, {0.01 + 1e-9, 0.001 + 1e-9});
        compared++;
    });
    EXPECT_EQ(missed, 0);
    EXPECT_GE(compared, 30 * seconds - 2);
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
    const auto bytes = player.conversation.stats().bytes_received - before;
    RecordProperty("bytes_per_second", std::to_string(bytes / seconds));
    EXPECT_LE(bytes, 8000u * seconds);
}

TEST(Precision, of_a_client_never_changes_the_world) {
    TestServer one, other;
    const auto first = one.host(*scenes::find_scene("asteroids")),
               second = other.host(*scenes::find_scene("asteroids"));
    SessionHarness plain(one, {});
    SessionHarness coarse(other, {.precision = client::Precision{1, 0.5}}),
        precise(other, {.precision = client::Precision{1e-4, 2e-4}});
    test::play(one, *first, {&plain}, 120);
    test::play(other, *second, {&coarse, &precise}, 120);
    const FramePtr a = first->frame(), b = second->frame();
    ASSERT_EQ(a->tick, b->tick);
    ASSERT_EQ(a->entities.size(), b->entities.size());
    for (std::size_t k = 0; k < a->entities.size(); k++)
        ASSERT_EQ(a->entities[k].pose, b->entities[k].pose) << k;
    EXPECT_EQ(misses(coarse, *b, {1, 0.5}), 0);
    EXPECT_EQ(misses(precise, *b, {1e-4, 2e-4}), 0);
}

TEST(Precision, of_the_client_precedes_that_of_the_world_and_of_the_server) {
    const auto spec_of = [](const SessionHarness& client) {
        return client.conversation.view().spec();
    };
    TestServer server({.stream = {.position_precision_m = 0.1, .rotation_precision_rad = 0.02}});
    scenes::SceneDescription scene = test::small_scene();
    const auto plain = server.host(scene);
    SessionHarness of_server(server, {});
    test::play(server, *plain, {&of_server}, 5);
    EXPECT_EQ(spec_of(of_server), snapshot::quant_spec_for({0.1, 0.02}));

    TestServer next({.stream = {.position_precision_m = 0.1, .rotation_precision_rad = 0.02}});
    scene.precision = {.position = 0.05, .rotation = 0.01};
    const auto world = next.host(scene);
    SessionHarness of_world(next, {}), of_client(next, {.precision = fine});
    test::play(next, *world, {&of_world, &of_client}, 5);
    EXPECT_EQ(spec_of(of_world), snapshot::quant_spec_for({0.05, 0.01}));
    EXPECT_EQ(spec_of(of_client), snapshot::quant_spec_for({0.01, 0.001}));

    TestServer old;
    const auto default_world = old.host(test::small_scene());
    SessionHarness of_default(old, {});
    test::play(old, *default_world, {&of_default}, 5);
    EXPECT_EQ(spec_of(of_default), snapshot::QuantSpec{});
}

// Bytes of the busiest second and of an average one, of samples per tick of 1/60 s.
struct Seconds {
    void add(std::uint64_t total) {
        totals.push_back(total);
        if (totals.size() > 61) totals.pop_front();
        if (totals.size() == 61) most = std::max(most, totals.back() - totals.front());
    }
    std::deque<std::uint64_t> totals;
    std::uint64_t most = 0;
};

TEST(Bandwidth, a_limit_is_used_to_90_percent_and_never_exceeded_in_any_second) {
    TestServer server;
    const auto world = server.host(*scenes::find_scene("asteroids_1000"));
    SessionHarness player(server, {.max_kbps = 500, .precision = client::Precision{1e-4, 2e-4}});
    Seconds seconds;
    std::uint64_t after_join = 0;
    constexpr int ticks = 60 * 15;
    test::play(server, *world, {&player}, ticks, [&](int tick) {
        seconds.add(player.conversation.stats().bytes_received);
        if (tick == 60 * 5) after_join = player.conversation.stats().bytes_received;
    });
    const double mean =
        static_cast<double>(player.conversation.stats().bytes_received - after_join) / 10;
    RecordProperty("mean", std::to_string(mean));
    RecordProperty("most", std::to_string(seconds.most));
    EXPECT_LE(seconds.most, 500'000u / 8);
    EXPECT_GE(mean, 0.9 * 500'000 / 8);
    // An entity that changes its cell is in neither until both were sent.
    EXPECT_GE(player.conversation.view().frame().entities.size(), 995u);
}

// A floor and 19,999 equal boxes, of which a row falls.
scenes::SceneDescription field_of_boxes() {
    scenes::SceneDescription scene{.name = "field"};
    scene.bodies.push_back({.name = "floor",
                            .body = {.type = physics::BodyType::static_body},
                            .shapes = {{.geometry = physics::Plane{}}}});
    for (int k = 0; k < 19'999; k++) {
        scenes::SceneBody box{.name = "box",
                              .shapes = {{.geometry = physics::Box{{0.4, 0.4, 0.4}}}}};
        box.body.pose.position = {k % 200 - 100.0, k % 100 == 0 ? 30.0 : 0.4, k / 200 - 50.0};
        scene.bodies.push_back(box);
    }
    return scene;
}

TEST(Bandwidth, motion_starts_within_a_second_of_joining_20000_boxes_at_1_Mbit_per_second) {
    TestServer server;
    const auto world = server.host(field_of_boxes());
    SessionHarness player(server, {.max_kbps = 1000});
    int first = 0, complete = 0;
    Seconds seconds;
    std::int32_t height = 0;
    test::play(server, *world, {&player}, 60 * 8, [&](int tick) {
        seconds.add(player.conversation.stats().bytes_received);
        const client::WorldView& view = player.conversation.view();
        if (complete == 0 && view.frame().entities.size() == 20'000) complete = tick;
        for (const snapshot::EntityState& state : view.frame().entities) {
            if (first != 0 || state.at_rest || state.position[1] < 5 * 512) continue;
            if (height != 0 && state.position[1] != height) first = tick;
            height = state.position[1];
            break;
        }
    });
    RecordProperty("first_motion_tick", std::to_string(first));
    RecordProperty("complete_tick", std::to_string(complete));
    EXPECT_GT(first, 0);
    EXPECT_LE(first, 60);
    EXPECT_GT(complete, 0);
    EXPECT_LE(seconds.most, 1'000'000u / 8);
}

TEST(Bandwidth, a_spectator_of_a_part_receives_only_entities_of_that_part) {
    TestServer server;
    const auto world = server.host(field_of_boxes());
    SessionHarness spectator(
        server,
        {.spectator = true, .interest = client::AreaOfInterest{.x = 0, .z = 0, .radius = 20}});
    test::play(server, *world, {&spectator}, 120);
    const std::size_t known = spectator.conversation.view().entities().size();
    EXPECT_GT(known, 1000u);
    EXPECT_LT(known,
              9000u);  // cells of 32 m within 20 m: at most 4 x 4 of them with 1024 boxes each
}

}  // namespace
}  // namespace jostle::server
