// SPDX-License-Identifier: MIT
//
// Triggers tell who comes, stays and goes, and touch nothing.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId add_trigger(World& world, const Geometry& geometry, Vec3 position,
                   BodyType type = BodyType::static_body, Filter filter = {}) {
    return must(world.create_body({.type = type, .pose = {position, {}}, .gravity_scale = 0},
                                  {.geometry = geometry, .filter = filter, .trigger = true}));
}

struct Visit {
    int entered = -1, left = -1, stayed = 0;  // steps
};

Visit watch(World& world, BodyId visitor, int steps) {
    Visit visit;
    for (int i = 0; i < steps; i++) {
        must(world.step(1.0 / 60));
        const Events e = world.events();
        for (const TriggerEvent& t : e.triggers_entered)
            if (t.body == visitor) visit.entered = i;
        for (const TriggerEvent& t : e.triggers_stayed)
            if (t.body == visitor) visit.stayed++;
        for (const TriggerEvent& t : e.triggers_left)
            if (t.body == visitor) visit.left = i;
    }
    return visit;
}

// A ball falls 2 m to the top of the gate and 1 m through it.
TEST(Triggers, ball_falls_through_a_gate_in_the_time_that_free_fall_takes) {
    World world = make_world();
    add_trigger(world, Box{{1, 0.5, 1}}, {0, 0, 0});
    const BodyId ball = add(world, {.geometry = Sphere{0.1}, .position = {0, 2.6, 0}});
    const Visit visit = watch(world, ball, 90);
    const double in = std::sqrt(2 * 2.0 / 9.81), out = std::sqrt(2 * 3.2 / 9.81);
    EXPECT_NEAR(visit.entered + 1, in * 60, 1);
    EXPECT_NEAR(visit.left + 1, out * 60, 1);
    EXPECT_EQ(visit.stayed, visit.left - visit.entered - 1);
    EXPECT_NEAR(velocity_of(world, ball).y, -9.81 * 1.5, 1e-6) << "nothing was touched";
}

TEST(Triggers, respect_their_mask) {
    World world = make_world();
    add_trigger(world, Sphere{1}, {0, 0, 0}, BodyType::static_body, {.mask = 4});
    const BodyId seen = must(world.create_body(
        {.pose = {{0, 2, 0}, {}}}, {.geometry = Sphere{0.1}, .filter = {.category = 4}}));
    const BodyId unseen = must(world.create_body(
        {.pose = {{0.5, 2, 0}, {}}}, {.geometry = Sphere{0.1}, .filter = {.category = 2}}));
    int entered = 0;
    for (int i = 0; i < 90; i++) {
        must(world.step(1.0 / 60));
        for (const TriggerEvent& t : world.events().triggers_entered) {
            EXPECT_EQ(t.body, seen);
            EXPECT_NE(t.body, unseen);
            entered++;
        }
    }
    EXPECT_EQ(entered, 1);
}

TEST(Triggers, moving_trigger_detects_static_and_sleeping_bodies) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {3, 0.5, 0}});
    const BodyId wall =
        add(world,
            {.geometry = Box{{0.1, 1, 1}}, .position = {5, 1, 0}, .type = BodyType::static_body});
    run(world, 2);
    ASSERT_FALSE(state_of(world, box).awake);
    const BodyId sweeper = add_trigger(world, Sphere{0.3}, {0, 0.6, 0}, BodyType::kinematic);
    must(world.set_velocity(sweeper, {3, 0, 0}, {}));
    std::vector<BodyId> met;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        for (const TriggerEvent& t : world.events().triggers_entered) met.push_back(t.body);
    }
    EXPECT_EQ(met, (std::vector<BodyId>{box, wall}));
    EXPECT_FALSE(state_of(world, box).awake) << "a trigger wakes nobody";
}

TEST(Triggers, new_trigger_detects_a_sleeping_body) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    ASSERT_FALSE(state_of(world, box).awake);
    add_trigger(world, Box{}, {0, 1, 0});
    const Visit visit = watch(world, box, 5);
    EXPECT_EQ(visit.entered, 0);
    EXPECT_EQ(visit.stayed, 4);
    EXPECT_EQ(visit.left, -1);
}

TEST(Triggers, destroying_a_body_inside_reports_an_exit) {
    World world = make_world({.gravity = {}});
    add_trigger(world, Box{}, {});
    const BodyId ball = add(world, {.geometry = Sphere{0.1}});
    run(world, 0.1);
    must(world.destroy_body(ball));
    must(world.step(1.0 / 60));
    ASSERT_EQ(world.events().triggers_left.size(), 1u);
    EXPECT_EQ(world.events().triggers_left[0].body, ball);
}

// Visits of one trigger by one body, and whether each of them began before it ended.
struct Visits {
    int entered = 0, left = 0;
    bool ordered = true;

    void count(const World& world) {
        entered += static_cast<int>(world.events().triggers_entered.size());
        left += static_cast<int>(world.events().triggers_left.size());
        const int inside = entered - left;
        ordered = ordered && (inside == 0 || inside == 1);
    }
};

Visits count_visits(World& world, int steps) {
    Visits visits;
    for (int i = 0; i < steps; i++) {
        must(world.step(1.0 / 60));
        visits.count(world);
    }
    return visits;
}

struct Flight {
    Geometry body, trigger;
    BodyType type = BodyType::static_body;  // of the trigger
};

std::vector<Flight> flights() {
    const Geometry plate = Box{{0.025, 1, 1}};
    return {{Sphere{0.05}, plate},
            {Box{{0.04, 0.05, 0.06}}, plate},
            {Capsule{.radius = 0.03, .half_length = 0.2}, plate},
            {Cylinder{.radius = 0.1, .half_length = 0.03}, plate},
            {Sphere{0.05}, Sphere{0.4}},
            {Box{{0.05, 0.05, 0.05}}, Capsule{.radius = 0.1, .half_length = 0.8}},
            {Sphere{0.05}, plate, BodyType::kinematic}};
}

TEST(Triggers, report_every_fast_body_that_passes_through_within_a_step) {
    for (const Flight& flight : flights())
        for (const double speed : {20.0, 200.0})
            for (int k = 0; k < 20; k++) {
                World world = make_world({.gravity = {}});
                add_trigger(world, flight.trigger, {}, flight.type);
                add(world, {.geometry = flight.body,
                            .position = {-5 - 0.137 * k, 0.1, 0.1},
                            .velocity = {speed, 0, 0},
                            .spin = {0, 3.0 * k, 0}});
                const Visits visits = count_visits(world, 40);
                EXPECT_EQ(visits.entered, 1) << speed << " m/s, flight " << k;
                EXPECT_EQ(visits.left, 1) << speed << " m/s, flight " << k;
                EXPECT_TRUE(visits.ordered);
            }
}

TEST(Triggers, report_a_graze_between_two_steps_once) {
    for (const double offset : {-2e-3, 2e-3}) {
        World world = make_world({.gravity = {}});
        add_trigger(world, Box{{0.025, 1, 1}}, {});
        add(world,
            {.geometry = Sphere{0.05}, .position = {-1, 1.05 + offset, 0}, .velocity = {2, 0, 0}});
        const Visits visits = count_visits(world, 60);
        EXPECT_EQ(visits.entered, offset < 0 ? 1 : 0);
        EXPECT_EQ(visits.left, visits.entered);
    }
}

TEST(Triggers, report_bodies_that_a_fast_trigger_passes) {
    World world = make_world({.gravity = {}});
    add(world, {.geometry = Sphere{0.05}, .position = {0, 0.1, 0}});
    add_static(world, {.geometry = Sphere{0.05}, .position = {0.3, -0.1, 0}});
    const BodyId plate = add_trigger(world, Box{{0.025, 1, 1}}, {-3, 0, 0}, BodyType::kinematic);
    must(world.set_velocity(plate, {100, 0, 0}, {}));
    const Visits visits = count_visits(world, 20);
    EXPECT_EQ(visits.entered, 2);
    EXPECT_EQ(visits.left, 2);
}

// The bar turns by 72 degrees in a step and passes each ball twice in a turn.
TEST(Triggers, rotating_bar_reports_each_pass) {
    World world = make_world({.gravity = {}});
    const BodyId bar = add_trigger(world, Box{{2, 0.02, 0.02}}, {}, BodyType::kinematic);
    must(world.set_velocity(bar, {}, {0, 0, 2 * pi * 12}));
    add_static(world, {.geometry = Sphere{0.05}, .position = {0.9, 1.2, 0}});
    const Visits visits = count_visits(world, 60);  // 12 turns
    EXPECT_EQ(visits.entered, 24);
    EXPECT_EQ(visits.left, 24);
}

// The ball flies through the trigger, bounces off the wall and flies back, all in one step.
TEST(Triggers, body_that_bounces_back_through_a_trigger_enters_and_leaves_once) {
    World world = make_world({.gravity = {}});
    add_trigger(world, Box{{0.025, 1, 1}}, {});
    add_static(world, {.geometry = Box{{0.5, 2, 2}}, .position = {1, 0, 0}, .restitution = 1});
    add(world, {.geometry = Sphere{0.05},
                .position = {-0.5, 0, 0},
                .velocity = {150, 0, 0},
                .restitution = 1});
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.events().triggers_entered.size(), 1u);
    EXPECT_EQ(world.events().triggers_left.size(), 1u);
    EXPECT_EQ(count_visits(world, 20).entered, 0);
}

TEST(Triggers, teleported_body_enters_nothing_on_the_way) {
    World world = make_world({.gravity = {}});
    add_trigger(world, Box{{0.025, 1, 1}}, {});
    const BodyId ball = add(world, {.geometry = Sphere{0.05}, .position = {-3, 0, 0}});
    run(world, 0.1);
    must(world.set_pose(ball, {{3, 0, 0}, {}}));
    EXPECT_EQ(count_visits(world, 5).entered, 0);
}

}  // namespace
}  // namespace jostle::test
