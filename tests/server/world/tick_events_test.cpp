// SPDX-License-Identifier: MIT
//
// What a world tells of its ticks: who touched whom, by entity, once per event.
#include "server/world/tick_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "server/world/hosted_world.h"
#include "server/world/world_host.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

using test::dt;

scenes::SceneDescription floor_alone() {
    scenes::SceneDescription scene;
    scene.name = "floor";
    const physics::ShapeDef slab{.geometry = physics::Box{{50, 0.5, 50}},
                                 .pose = {.position = {0, -0.5, 0}}};
    scene.bodies.push_back(
        {.name = "floor", .body = {.type = physics::BodyType::static_body}, .shapes = {slab}});
    return scene;
}

class TickEventsTest : public testing::Test {
protected:
    InputResult apply(Action action) {
        return world.apply(
            {.client = 1, .sequence = ++sequence, .action = std::move(action), .reply = {}}, tick);
    }
    // A ball whose lowest point is `height` above the floor.
    EntityId drop_ball(double height, double x = 0) {
        SpawnCommand spawn;
        spawn.shape.geometry = physics::Sphere{0.5};
        spawn.pose.position = {x, height + 0.5, 0};
        return apply(spawn).entity;
    }
    std::vector<TickEvents> run(int ticks) {
        std::vector<TickEvents> happened;
        for (int i = 0; i < ticks; i++) {
            EXPECT_TRUE(world.step(dt).ok());
            if (auto events = world.events_of_step(++tick)) happened.push_back(*std::move(events));
        }
        return happened;
    }

    HostedWorld world = std::move(*HostedWorld::create(floor_alone(), {}, 1));
    std::uint32_t sequence = 0, tick = 0;
    static constexpr EntityId floor = 1;
};

template <class Member>
auto all(const std::vector<TickEvents>& ticks, Member member) {
    std::remove_cvref_t<decltype(ticks[0].*member)> out;
    for (const TickEvents& events : ticks)
        out.insert(out.end(), (events.*member).begin(), (events.*member).end());
    return out;
}

TEST_F(TickEventsTest, dropped_ball_reports_one_hit_at_its_fall_speed) {
    const EntityId ball = drop_ball(5);
    const auto ticks = run(120);
    const double speed = std::sqrt(2 * 9.81 * 5);
    const auto began = all(ticks, &TickEvents::contacts_began);
    ASSERT_EQ(began.size(), 1u);
    EXPECT_EQ(std::minmax(began[0].a, began[0].b), std::minmax(floor, ball));
    EXPECT_NEAR(began[0].speed, speed, 0.02 * speed);
    EXPECT_NEAR(began[0].point.y, 0, 0.1) << "halfway, before the step in which they met";
    EXPECT_NEAR(began[0].normal.y, began[0].a == floor ? 1 : -1, 1e-6) << "from a to b";
    const auto hits = all(ticks, &TickEvents::hits);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].speed, speed, 0.02 * speed);
    EXPECT_TRUE(all(ticks, &TickEvents::contacts_ended).empty());
    EXPECT_EQ(all(ticks, &TickEvents::fell_asleep), std::vector{ball});
}

TEST_F(TickEventsTest, contact_end_names_a_deleted_body_after_index_reuse) {
    const EntityId ball = drop_ball(0.1);
    run(30);
    EXPECT_TRUE(apply(DeleteCommand{ball}).status.ok());
    const EntityId heir = drop_ball(0.1);  // with the body that has become free
    const auto ticks = run(30);
    const auto ended = all(ticks, &TickEvents::contacts_ended);
    ASSERT_EQ(ended.size(), 1u);
    EXPECT_EQ(std::minmax(ended[0].a, ended[0].b), std::minmax(floor, ball));
    const auto began = all(ticks, &TickEvents::contacts_began);
    ASSERT_EQ(began.size(), 1u);
    EXPECT_EQ(std::minmax(began[0].a, began[0].b), std::minmax(floor, heir));
}

TEST_F(TickEventsTest, sorts_events_by_entity) {
    for (int i = 0; i < 10; i++) drop_ball(1, 40 - 3.0 * i);
    const auto began = all(run(60), &TickEvents::contacts_began);
    ASSERT_EQ(began.size(), 10u);
    EXPECT_TRUE(std::ranges::is_sorted(began, {},
                                       [](const ContactEvent& c) { return std::pair(c.a, c.b); }));
}

TEST_F(TickEventsTest, reports_nothing_when_nothing_happens) {
    drop_ball(5);
    EXPECT_TRUE(run(10).empty());
}

TEST(Quarantine, reports_a_quarantined_body_once) {
    scenes::SceneDescription scene = floor_alone();
    scene.world.gravity = {0, -1e4, 0};
    const physics::ShapeDef ball{.geometry = physics::Sphere{0.5}};
    scene.bodies.push_back(
        {.name = "comet",
         .body = {.pose = {.position = {1000, 9.9e6, 0}}, .gravity_scale = -1000},
         .shapes = {ball}});
    HostedWorld world = std::move(*HostedWorld::create(scene, {}, 1));
    int told = 0;
    for (int i = 0; i < 60; i++) {  // 1e7 m/s^2: past 1e6 m/s within six ticks, again and again
        ASSERT_TRUE(world.step(dt).ok());
        for (const auto& entity : world.newly_quarantined()) {
            told++;
            EXPECT_EQ(entity->name, "comet");
        }
    }
    EXPECT_EQ(told, 1);
}

TEST(WorldHostEvents, frames_contain_the_newest_64_event_ticks_while_listened) {
    scenes::SceneDescription scene = floor_alone();
    scene.hz = 240;
    // Something happens in every tick.
    const physics::ShapeDef ball{.geometry = physics::Sphere{0.5}, .report_stays = true};
    scene.bodies.push_back({.name = "ball",
                            .body = {.pose = {.position = {0, 0.5, 0}}, .sleep_allowed = false},
                            .shapes = {ball}});
    const auto host = *WorldHost::start("w1", "floor", scene, {});
    const auto wait = [&](auto condition) {
        for (const auto end = Clock::now() + 10s; Clock::now() < end && !condition();)
            std::this_thread::sleep_for(1ms);
        return condition();
    };
    ASSERT_TRUE(wait([&] { return host->frame()->tick > 20; }));
    EXPECT_EQ(host->frame()->events->count, 0u) << "nobody asked";
    host->listeners().events++;
    ASSERT_TRUE(wait([&] { return host->frame()->events->count > 100; }));
    const FramePtr frame = host->frame();
    ASSERT_EQ(frame->events->ticks.size(), 64u);
    EXPECT_EQ(frame->events->ticks.back()->tick, frame->tick);
    for (std::size_t i = 1; i < 64; i++)
        EXPECT_EQ(frame->events->ticks[i]->tick, frame->events->ticks[i - 1]->tick + 1);
    EXPECT_NEAR(frame->events->ticks.back()->contacts.at(0).impulse,
                9.81 * 1000 * 4.0 / 3 * std::numbers::pi * 0.125 / 240, 0.5)
        << "its weight over a tick";
    host->listeners().events--;
    EXPECT_TRUE(wait([&] { return host->frame()->events->ticks.empty(); }));
}

}  // namespace
}  // namespace jostle::server
