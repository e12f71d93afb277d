// SPDX-License-Identifier: MIT
//
// Small islands are solved side by side, a batch of them on each thread; what is one island, or
// leans on a kinematic body, is not. No result depends on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

World boxes_that_lie_about(int count, int threads) {
    World world = make_world({.threads = threads, .sleeping = false});
    add_floor(world);
    for (int k = 0; k < count; k++) add(world, {.position = {k % 40 * 1.5, 0.5, k / 40 * 1.5}});
    return world;
}

int tasks_after(World& world, double seconds) {
    run(world, seconds);
    return world.profile().solver_tasks;
}

TEST(Batches, two_threads_solve_two_batches_of_900_scattered_boxes) {
    World world = boxes_that_lie_about(900, 2);
    EXPECT_EQ(tasks_after(world, 0.5), 2);
    EXPECT_EQ(world.profile().bodies_in_solver, 900);
}

TEST(Batches, four_threads_solve_four_batches_of_2000_boxes) {
    World world = boxes_that_lie_about(2000, 4);
    EXPECT_EQ(tasks_after(world, 0.5), 4);
}

TEST(Batches, one_thread_or_few_islands_have_no_batches) {
    World alone = boxes_that_lie_about(900, 1), few = boxes_that_lie_about(500, 2);
    EXPECT_EQ(tasks_after(alone, 0.5), 0);
    EXPECT_EQ(tasks_after(few, 0.5), 0);
}

// 1000 boxes in rows that touch: one island, solved as a whole.
TEST(Batches, one_large_island_is_not_batched) {
    World world = make_world({.threads = 2, .sleeping = false});
    add_floor(world);
    for (int k = 0; k < 1000; k++)
        add(world, {.position = {k % 20 * 1.0, 0.5 + k / 20 % 5, k / 100 * 1.0}});
    EXPECT_EQ(tasks_after(world, 0.5), 0);
    EXPECT_EQ(world.profile().islands_awake, 0) << "sleeping is off: nobody counts";
    EXPECT_GT(world.profile().manifolds, 1000);
}

// All stand on a floor that is lifted: whoever solves them moves it on, sub-step by sub-step.
TEST(Batches, body_on_a_kinematic_floor_is_solved_with_it) {
    const auto lifted = [](int threads) {
        World world = make_world({.threads = threads, .sleeping = false});
        add(world, {.geometry = Box{{50, 1, 50}},
                    .position = {30, -1, 17},
                    .velocity = {0, 0.5, 0},
                    .type = BodyType::kinematic});
        for (int k = 0; k < 900; k++) add(world, {.position = {k % 40 * 1.5, 0.5, k / 40 * 1.5}});
        return world;
    };
    World one = lifted(1), two = lifted(2);
    run(one, 1);
    EXPECT_EQ(tasks_after(two, 1), 0);
    EXPECT_EQ(state_hash(one), state_hash(two));
    for (const BodyId body : two.bodies()) {
        if (state_of(two, body).type != BodyType::dynamic) continue;
        EXPECT_NEAR(position_of(two, body).y, 1, 2e-3);
    }
}

// Two rows of 30 towers of ten lean on each other when one row is pushed over: islands of different
// batches become one, and the world is what it is with one thread, and what it is when it was saved
// and loaded on the way.
TEST(Batches, colliding_towers_of_different_batches_remain_valid) {
    const auto make = [](int threads) {
        World world = make_world({.threads = threads, .sleeping = false});
        add_floor(world);
        for (int tower = 0; tower < 60; tower++)
            for (int k = 0; k < 10; k++)
                add(world, {.position = {tower % 30 * 2.5, 0.5 + k, tower / 30 * 2.5},
                            .velocity = {0, 0, tower < 30 ? 0.1 * k * k : 0}});
        return world;
    };
    World one = make(1), two = make(2), loaded = make(2);
    int most = 0;
    for (int step = 0; step < 180; step++) {
        if (step == 100) loaded = must(load(save(loaded)));
        for (World* world : {&one, &two, &loaded}) must(world->step(1.0 / 60));
        most = std::max(most, two.profile().solver_tasks);
    }
    EXPECT_GE(most, 2);
    EXPECT_EQ(state_hash(one), state_hash(two)) << first_difference(one, two).value_or("");
    EXPECT_EQ(state_hash(one), state_hash(loaded)) << first_difference(one, loaded).value_or("");
}

// The scene whose golden hashes say that all machines agree on this has batches indeed.
TEST(Batches, village_scene_has_at_least_two_batches_until_it_sleeps) {
    World world = village_scene(2);
    int most = 0;
    for (int step = 0; step < 40; step++) {
        must(world.step(1.0 / 60));
        most = std::max(most, world.profile().solver_tasks);
    }
    EXPECT_GE(most, 2);
}

}  // namespace
}  // namespace jostle::test
