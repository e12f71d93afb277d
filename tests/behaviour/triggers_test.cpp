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

}  // namespace
}  // namespace jostle::test
