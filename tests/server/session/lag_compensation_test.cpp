// SPDX-License-Identifier: MIT
//
// Who aims at what he sees aims at the past. A shooter with 150 ms between him and the server, and
// a target that runs: does the server hit what was in the picture?
#include <gtest/gtest.h>

#include <cmath>

#include "jostle/scenes/scene.h"
#include "jostle/v1/query.pb.h"
#include "server/services/query_control.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using physics::Vec3;
using test::SessionHarness;
using test::TestServer;

constexpr EntityId wall = 1, target = 2;

// Entity 2 runs along x at 10 m/s, ten metres before a wall; without weight.
scenes::SceneDescription range_scene(double target_speed = 10) {
    scenes::SceneDescription scene{.name = "range"};
    scene.world.gravity = {};
    scenes::SceneBody back;
    back.body.pose.position = {0, 0, -10};
    back.body.type = physics::BodyType::static_body;
    back.shapes.push_back({.geometry = physics::Box{{200, 10, 0.5}}});
    scenes::SceneBody runner;
    runner.body.linear_velocity = {target_speed, 0, 0};
    runner.body.sleep_allowed = false;
    runner.shapes.push_back({.geometry = physics::Sphere{0.3}});
    scene.bodies = {back, runner};
    return scene;
}

// Straight at what is at x in the picture, from ten metres before it.
v1::Aim shot_at(double x, double length = 15) {
    v1::Aim aim;
    aim.mutable_origin()->set_x(x);
    aim.mutable_origin()->set_z(10);
    aim.mutable_motion()->set_z(-length);
    return aim;
}

v1::Input push_at(double x) {
    v1::Input input;
    input.mutable_impulse()->mutable_impulse()->set_z(-1e-6);
    *input.mutable_impulse()->mutable_aim() = shot_at(x);
    return input;
}

std::optional<double> x_of(const std::vector<client::SmoothPose>& picture, EntityId entity) {
    for (const client::SmoothPose& shown : picture)
        if (shown.entity == entity) return shown.pose.position[0];
    return std::nullopt;
}

struct Round {
    int shots = 0, hits = 0, misses = 0, clamped = 0;
    int of_what_was = 0;  // shots while the picture walked off no error: it showed what once was
};

// Eight seconds of which the last six are shot in, three times a second.
Round shoot(bool attach_view_time, NetworkConditions each_way, double rewind_ms = 400) {
    Config config;
    config.tick.lag_compensation_ms_max = rewind_ms;
    TestServer server(config);
    const auto world = server.host(range_scene());
    SessionHarness shooter(server, {.name = "shooter", .attach_view_time = attach_view_time},
                           each_way);
    Round round;
    test::play(server, *world, {&shooter}, 8 * 60, [&](int tick) {
        const std::optional<double> view_time = x_of(shooter.draw(), target);
        if (view_time && tick > 2 * 60 && tick % 20 == 0 && tick < 460) {
            shooter.conversation.send(push_at(*view_time));
            round.shots++;
            const v1::ViewTime moment = shooter.conversation.rendered_time();
            const double was =
                10 * (moment.tick() + static_cast<double>(moment.fraction()) - 1) / 60;
            round.of_what_was += std::abs(*view_time - was) < 0.2 ? 1 : 0;
        }
        for (const v1::InputResult& result : shooter.conversation.take_results()) {
            const bool hit = result.code() == v1::INPUT_CODE_APPLIED && result.entity() == target;
            round.hits += hit ? 1 : 0;
            round.misses += result.code() == v1::INPUT_CODE_NOT_FOUND ? 1 : 0;
            round.clamped += result.view_time_clamped() ? 1 : 0;
        }
    });
    return round;
}

TEST(LagCompensation, hits_rendered_target_at_150_ms_latency_only_with_view_time) {
    const NetworkConditions network{.latency_ms = 75};
    const Round with = shoot(true, network), without = shoot(false, network);
    EXPECT_EQ(with.shots, 16);
    EXPECT_EQ(with.hits, with.shots);
    EXPECT_EQ(with.clamped, 0);
    EXPECT_EQ(without.shots, 16);
    EXPECT_EQ(without.hits, 0) << "the target was two metres further";
    EXPECT_EQ(without.misses, without.shots);
}

TEST(LagCompensation, jitter_does_not_change_the_result) {
    const Round round = shoot(true, {.latency_ms = 60, .jitter_ms = 40, .seed = 3});
    EXPECT_GE(round.of_what_was, 12);
    EXPECT_EQ(round.hits, round.of_what_was);
    EXPECT_EQ(round.clamped, 0);
}

TEST(LagCompensation, clamps_view_time_older_than_history_and_reports_it) {
    const Round round = shoot(true, {.latency_ms = 75}, 100);
    EXPECT_EQ(round.hits, 0) << "100 ms of the past are not enough";
    EXPECT_EQ(round.clamped, round.shots) << "and every answer says so";
}

TEST(LagCompensation, does_not_hit_entities_created_after_view_time) {
    TestServer server;
    const auto world = server.host(range_scene(0));
    SessionHarness shooter(server, {.name = "shooter"});
    test::play(server, *world, {&shooter}, 30);
    const std::uint32_t before = world->frame()->tick;
    v1::Input ball;
    ball.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(0.3);
    ball.mutable_spawn()->mutable_position()->set_z(5);
    shooter.conversation.send(ball);
    test::play(server, *world, {&shooter}, 10);
    const auto shoot_as_of = [&](std::uint32_t tick) {
        v1::Input input = push_at(0);
        input.mutable_impulse()->mutable_aim()->mutable_view_time()->set_tick(tick);
        shooter.conversation.take_results();
        shooter.conversation.send(input);
        test::play(server, *world, {&shooter}, 5);
        const auto results = shooter.conversation.take_results();
        return results.empty() ? 0u : results.front().entity();
    };
    EXPECT_EQ(shoot_as_of(before), target) << "the ball that now hides it was not there";
    EXPECT_EQ(shoot_as_of(world->frame()->tick), world->frame()->entity_list->back()->id);
}

TEST(LagCompensation, grabs_the_rendered_point_at_its_current_position) {
    TestServer server;
    const auto world = server.host(range_scene());
    SessionHarness shooter(server, {.name = "shooter"}, {.latency_ms = 75});
    v1::Input grab;
    test::play(server, *world, {&shooter}, 120, [&](int tick) {
        const std::optional<double> view_time = x_of(shooter.draw(), target);
        if (tick != 100) return;
        *grab.mutable_grab()->mutable_aim() = shot_at(*view_time);
        shooter.conversation.send(grab);
    });
    const auto results = shooter.conversation.take_results();
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results[0].code(), v1::INPUT_CODE_APPLIED) << results[0].message();
    EXPECT_EQ(results[0].entity(), target);
    // It is held where it is when the hand comes, and not pulled to where it was seen.
    const double taken_at = 10.0 * (results[0].tick() - 1) / 60;
    EXPECT_NEAR(world->frame()->entities[1].pose.position.x, taken_at, 0.7);
    EXPECT_GT(taken_at - grab.grab().aim().origin().x(), 2);
}

TEST(LagCompensation, query_rpc_uses_the_view_time) {
    TestServer server;
    const auto world = server.host(range_scene());
    world->listeners().streams++;  // a player's, on whose behalf the queries are made
    for (int i = 0; i < 60; i++) {
        server.now += std::chrono::microseconds(16'667);
        world->tick(server.now);
    }
    const QueryControl queries(server.context);
    const auto ask = [&](double x, std::uint32_t tick, float fraction) {
        v1::CastRaysRequest request;
        *request.add_rays()->mutable_origin() = shot_at(x).origin();
        *request.mutable_rays(0)->mutable_motion() = shot_at(x, 25).motion();
        request.mutable_view_time()->set_tick(tick);
        request.mutable_view_time()->set_fraction(fraction);
        v1::CastRaysResponse response;
        const Status asked = queries.cast_rays(request, response);
        EXPECT_TRUE(asked.ok()) << asked.error().message;
        return response;
    };
    const std::uint32_t then = world->frame()->tick - 10;
    const double was = 10.0 * (then - 1 + 0.5) / 60;
    const v1::CastRaysResponse hit = ask(was, then, 0.5f);
    EXPECT_EQ(hit.tick(), then);
    EXPECT_FALSE(hit.view_time_clamped());
    ASSERT_EQ(hit.rays(0).hits_size(), 1);
    EXPECT_EQ(hit.rays(0).hits(0).entity(), target);
    EXPECT_NEAR(hit.rays(0).hits(0).point().z(), 0.3, 1e-6) << "right through its middle";
    EXPECT_EQ(ask(was, world->frame()->tick, 0).rays(0).hits(0).entity(), wall) << "it ran on";
    EXPECT_TRUE(ask(was, 1, 0).view_time_clamped());
    EXPECT_EQ(ask(was, 1, 0).tick(), world->frame()->tick - 24);

    v1::OverlapRequest overlap;
    overlap.mutable_point()->set_x(was);
    overlap.mutable_view_time()->set_tick(then);
    overlap.mutable_view_time()->set_fraction(0.5f);
    v1::OverlapResponse inside;
    ASSERT_TRUE(queries.overlap(overlap, inside).ok());
    ASSERT_EQ(inside.entities_size(), 1);
    EXPECT_EQ(inside.entities(0), target);
    overlap.mutable_view_time()->set_fraction(1.5f);
    EXPECT_EQ(test::error_of(queries.overlap(overlap, inside)).message,
              "view_time.fraction is 1.5; it must be from 0 to 1");
}

}  // namespace
}  // namespace jostle::server
