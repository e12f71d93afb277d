// SPDX-License-Identifier: MIT
//
// A budget for the step: a world that does too much gives things up in the stated order, by counted
// work alone, and takes them back when the load is gone.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Cubes that tumble into each other over a floor.
World make_tumbling_world(std::int64_t budget, int threads = 1) {
    World world = make_world({.step_budget = budget, .threads = threads, .sleeping = false});
    add_floor(world);
    for (int k = 0; k < 216; k++)
        add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                    .position = {0.45 * (k % 6), 0.4 + 0.45 * (k / 36), 0.45 * (k / 6 % 6)},
                    .velocity = {3.0 - k % 6, 0, 3.0 - k / 6 % 6},
                    .spin = {3, 1.0 * (k % 5), -2}});
    return world;
}

void step(World& world, int count = 1) {
    for (int k = 0; k < count; k++) must(world.step(1.0 / 60));
}

// Of a second, after the strain has risen.
std::int64_t work_of_a_second(World world) {
    step(world, 5);
    std::int64_t work = 0;
    for (int k = 0; k < 60; k++) {
        step(world);
        work += world.profile().work;
    }
    return work;
}

TEST(StepBudget, world_without_a_budget_is_never_overloaded) {
    World world = make_tumbling_world(0);
    for (int k = 0; k < 60; k++) {
        step(world);
        EXPECT_EQ(world.overload_level(), 0);
        EXPECT_EQ(world.profile().overload_level, 0);
        EXPECT_GT(world.profile().work, 0);
    }
}

TEST(StepBudget, unreached_budget_does_not_change_the_motion) {
    World world = make_tumbling_world(4294967295), free = make_tumbling_world(0);
    step(world, 120);
    step(free, 120);
    EXPECT_EQ(world.overload_level(), 0);
    EXPECT_EQ(world.summary().kinetic_energy, free.summary().kinetic_energy);
    EXPECT_EQ(world.summary().angular_momentum, free.summary().angular_momentum);
}

TEST(StepBudget, overload_level_rises_by_one_per_step_and_reduces_work) {
    World world = make_tumbling_world(1);
    int before = 0;
    for (const int level : {1, 2, 3, 3, 3}) {
        step(world);
        EXPECT_EQ(world.profile().overload_level, before);
        EXPECT_EQ(world.overload_level(), level);
        before = level;
    }
    const std::int64_t all = work_of_a_second(make_tumbling_world(0)),
                       strained = work_of_a_second(make_tumbling_world(1));
    EXPECT_LT(static_cast<double>(strained), 0.8 * static_cast<double>(all));
}

TEST(StepBudget, is_bit_identical_for_one_and_three_threads) {
    World one = make_tumbling_world(2000, 1), three = make_tumbling_world(2000, 3);
    for (int k = 0; k < 90; k++) {
        step(one);
        step(three);
        ASSERT_EQ(one.profile().work, three.profile().work) << k;
        ASSERT_EQ(state_hash(one), state_hash(three)) << k;
    }
    EXPECT_GT(one.overload_level(), 0);
}

TEST(StepBudget, overloaded_world_continues_identically_after_save_or_restore) {
    World world = make_tumbling_world(1);
    step(world, 2);
    ASSERT_EQ(world.overload_level(), 2);
    World copy = must(load(save(world)));
    EXPECT_EQ(copy.overload_level(), 2);
    EXPECT_EQ(copy.step_budget(), 1);
    RestorePoint kept;
    kept.capture(world);
    std::vector<std::uint64_t> hashes;
    for (int k = 0; k < 40; k++) {
        step(world);
        step(copy);
        hashes.push_back(state_hash(world));
        ASSERT_EQ(hashes.back(), state_hash(copy)) << k;
    }
    must(kept.restore(world));
    for (const std::uint64_t hash : hashes) {
        step(world);
        ASSERT_EQ(state_hash(world), hash);
    }
}

TEST(StepBudget, no_body_tunnels_through_a_plate_at_100_m_s_at_the_highest_overload_level) {
    World world = make_world({.step_budget = 1, .sleeping = false});
    add_static(world, {.geometry = Box{{20, 0.01, 20}}});
    // Each in its own time, from 1 m upwards, and some in a column that hits what lies there.
    std::vector<BodyId> balls;
    for (int k = 0; k < 300; k++)
        balls.push_back(
            add(world, {.geometry = Sphere{0.1},
                        .position = {0.5 * (k % 10) - 2.5, 1 + 1.1 * (k / 100 * 10 + k % 7),
                                     0.5 * (k / 10 % 10) - 2.5},
                        .velocity = {0, -100, 0}}));
    step(world, 60);
    EXPECT_EQ(world.overload_level(), 3);
    for (const BodyId ball : balls) EXPECT_GT(position_of(world, ball).y, 0.05);
}

TEST(StepBudget, overload_level_falls_one_by_one_once_the_load_is_gone) {
    World world = make_world({.step_budget = 100, .sleeping = false});
    add_floor(world);
    const BodyId box = add(world, {.position = {50, 0.5, 0}});
    std::vector<BodyId> load;
    for (int k = 0; k < 100; k++) load.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
    step(world, 10);
    ASSERT_EQ(world.overload_level(), 3);
    for (const BodyId body : load) must(world.destroy_body(body));
    for (const int level : {3, 2, 1}) {
        step(world, 29);
        EXPECT_EQ(world.overload_level(), level);
        step(world);
        EXPECT_EQ(world.overload_level(), level - 1);
    }
    step(world, 60);
    EXPECT_EQ(world.overload_level(), 0);
    EXPECT_NEAR(position_of(world, box).y, 0.5, 1e-4);
}

TEST(StepBudget, loads_and_heights_are_unchanged_by_substep_length) {
    World world = make_world({.step_budget = 1000, .sleeping = false});
    add_floor(world);
    must(world.create_body({.pose = {{0, 0.5, 0}, {}}}, {.geometry = Box{}, .report_stays = true}));
    const BodyId high = add(world, {.position = {0, 1.5, 0}});
    const auto load = [&] {
        double impulse = 0;  // N s in a step
        for (const ContactStay& stay : world.events().contacts)
            impulse = std::max(impulse, stay.normal_impulse);
        return impulse;
    };
    step(world, 120);
    ASSERT_EQ(world.overload_level(), 0);
    const double height = position_of(world, high).y, both = 2 * 1000 * 9.81 / 60;
    EXPECT_NEAR(load(), both, 0.01 * both);
    std::vector<BodyId> others;
    for (int k = 0; k < 400; k++)
        others.push_back(add(world, {.position = {100.0 + 2 * k, 0.5, 0}}));
    for (int k = 0; k < 20; k++) {
        step(world);
        EXPECT_NEAR(position_of(world, high).y, height, 2e-5) << k;
        EXPECT_NEAR(load(), both, 0.05 * both) << k;
    }
    ASSERT_EQ(world.overload_level(), 3);
    for (const BodyId body : others) must(world.destroy_body(body));
    for (int k = 0; k < 40; k++) {
        step(world);
        EXPECT_NEAR(position_of(world, high).y, height, 2e-5) << k;
        EXPECT_NEAR(load(), both, 0.05 * both) << k;
    }
    EXPECT_EQ(world.overload_level(), 2);
}

TEST(StepBudget, body_that_fell_asleep_overloaded_carries_its_load_after_waking) {
    World world = make_world({.step_budget = 10});
    add_floor(world);
    BodyId top;
    for (int k = 0; k < 5; k++) top = add(world, {.position = {0, 0.5 + k, 0}});
    step(world, 50);
    ASSERT_EQ(world.overload_level(), 3);
    ASSERT_EQ(world.profile().bodies_awake, 0);
    const double height = position_of(world, top).y;
    step(world, 100);
    ASSERT_EQ(world.overload_level(), 0);
    must(world.wake(top));
    for (int k = 0; k < 3; k++) {
        step(world);
        EXPECT_NEAR(position_of(world, top).y, height, 1e-4) << k;
        EXPECT_LT(length(velocity_of(world, top)), 0.005) << k;
    }
}

TEST(StepBudget, pyramid_of_fifteen_rows_stands_at_the_highest_overload_level) {
    World world = make_world({.step_budget = 1, .sleeping = false});
    add_floor(world);
    BodyId top;
    for (int row = 0; row < 15; row++)
        for (int k = 0; k < 15 - row; k++)
            top = add(world, {.position = {k + 0.5 * row, 0.5 + row, 0}});
    step(world, 600);
    EXPECT_EQ(world.overload_level(), 3);
    EXPECT_NEAR(position_of(world, top).y, 14.5, 0.02);
    EXPECT_LT(length(velocity_of(world, top)), 0.01);
}

TEST(StepBudget, tower_and_heavy_load_keep_their_substeps_and_stand) {
    World world = make_world({.step_budget = 1, .sleeping = false});
    add_floor(world);
    BodyId top;
    for (int k = 0; k < 20; k++) top = add(world, {.position = {0, 0.5 + k, 0}});
    for (int k = 0; k < 5; k++) add(world, {.position = {20, 0.5 + k, 0}, .density = 10});
    const BodyId heavy = add(world, {.position = {20, 5.5, 0}, .density = 5000});
    step(world, 600);
    EXPECT_EQ(world.overload_level(), 3);
    EXPECT_LT(length(position_of(world, top) - Vec3{0, 19.5, 0}), 0.02);
    EXPECT_LT(length(position_of(world, heavy) - Vec3{20, 5.5, 0}), 0.02);
}

}  // namespace
}  // namespace jostle::test
