// SPDX-License-Identifier: MIT
//
// How often pairs are looked at.
#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// The checks of one second, after the pairs are known.
int checks_of(World& world) {
    must(world.step(1.0 / 60));
    int tasks = 0;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        tasks += world.profile().pairs_checked;
    }
    return tasks;
}

// It comes no nearer to the wall, however fast it falls. Turning would matter: it does not turn.
TEST(UpdateContacts, body_falling_along_a_wall_is_tested_once) {
    World world = make_world();
    add(world, {.geometry = Box{{0.5, 50, 5}}, .type = BodyType::static_body});
    add(world, {.position = {1.03, 40, 0}, .velocity = {0, -10, 0}});
    EXPECT_LE(checks_of(world), 1);
}

TEST(UpdateContacts, bodies_falling_side_by_side_are_not_tested) {
    World world = make_world();
    for (int i = 0; i < 100; i++)
        add(world,
            {.position = {1.1 * (i % 10), 100 + 1.1 * (i / 10), 0}, .velocity = {0, -20, 0}});
    EXPECT_EQ(checks_of(world), 0);
}

// Faster than the lower one by 6 m/s: 30 boxes pass 30 others at 5 cm, and none of them nears.
TEST(UpdateContacts, passing_columns_are_tested_a_few_times) {
    World world = make_world({.gravity = {}});
    for (int i = 0; i < 30; i++) {
        add(world, {.position = {0, 1.2 * i, 0}});
        add(world, {.position = {1.05, 1.2 * i, 0}, .velocity = {0, 6, 0}});
    }
    EXPECT_LE(checks_of(world), 600);
}

// Half a millimetre beside a sleeper lies what never sleeps. It woke it in every step.
TEST(UpdateContacts, resting_body_does_not_wake_its_sleeping_neighbour) {
    World world = make_world();
    add_floor(world);
    const BodyId sleeper = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    ASSERT_FALSE(state_of(world, sleeper).awake);
    add(world, {.position = {1.0005, 0.5, 0}, .sleep_allowed = false});
    run(world, 1);
    std::size_t woken = 0;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        woken += world.events().woke.size();
    }
    EXPECT_EQ(woken, 0u);
    EXPECT_FALSE(state_of(world, sleeper).awake);
}

}  // namespace
}  // namespace jostle::test
