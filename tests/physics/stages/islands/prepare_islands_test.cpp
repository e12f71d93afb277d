// SPDX-License-Identifier: MIT
//
// Who takes how many sub-steps: the tall tower twice as many, its low neighbour not, what bears a
// hundred times its mass four times.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

std::vector<BodyId> add_tower(World& world, int layers, double x) {
    std::vector<BodyId> boxes;
    for (int k = 0; k < layers; k++) boxes.push_back(add(world, {.position = {x, 0.5 + k, 0}}));
    return boxes;
}

// N: what the island presses the floor with, by the impulses of one sub-step.
double load_on_floor(const World& world, BodyId lowest, int substeps) {
    double impulse = 0;
    for (const ContactInfo& c : world.contacts())
        if (c.body_a == lowest && absolute(c.normal.y) > 0.9 && c.point[0].y < 0.1)
            for (int k = 0; k < c.count; k++) impulse += c.impulse[k];
    return impulse * substeps * 60;
}

TEST(Tiers, tower_of_60_boxes_takes_twice_the_substeps_and_a_stack_of_10_does_not) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add_tower(world, 60, 0);
    add_tower(world, 10, 5);
    run(world, 0.5);
    EXPECT_EQ(world.profile().bodies_in_solver, 70);
    EXPECT_EQ(world.profile().bodies_tall, 60);
}

TEST(Tiers, scattered_boxes_take_half_the_substeps_until_a_fast_body_arrives) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int k = 0; k < 6; k++) add(world, {.position = {2.0 * k, 0.5, 0}});
    run(world, 1);
    EXPECT_EQ(world.profile().bodies_flat, 6);
    add(world, {.geometry = Sphere{0.5}, .position = {2, 1.6, 0}, .velocity = {0, -8, 0}});
    int least = 6;
    for (int k = 0; k < 12; k++) {
        must(world.step(1.0 / 60));
        least = std::min(least, world.profile().bodies_flat);
    }
    EXPECT_EQ(least, 5);
}

TEST(Tiers, overhanging_box_sinks_at_no_point) {
    // Four fifths of its weight is on the edge of the lower one: learned point by point, no gap is
    // left below the slop.
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    add(world, {.position = {0.3, 1.5, 0}, .density = 8000});
    run(world, 5);
    double lowest = 0;
    for (const ContactInfo& c : world.contacts())
        for (int k = 0; k < c.count; k++) lowest = std::min(lowest, c.gap[k]);
    EXPECT_GT(lowest, -0.0002);
}

TEST(Tiers, floor_load_is_unchanged_when_the_tier_changes) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> tower = add_tower(world, 38, 0);
    run(world, 2);
    ASSERT_EQ(world.profile().bodies_tall, 0);
    const double weight = 38 * must(world.body(tower[0])).mass * 9.81;
    EXPECT_NEAR(load_on_floor(world, tower[0], 8) / weight, 1, 0.01);
    for (int k = 38; k < 42; k++) tower.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
    double before = 0;
    for (int k = 0; k < 60 && world.profile().bodies_tall == 0; k++) {
        before = load_on_floor(world, tower[0], 8);
        must(world.step(1.0 / 60));
    }
    ASSERT_EQ(world.profile().bodies_tall, 42);
    // The four new ones are on their way to being borne, and not half or twice as much.
    EXPECT_NEAR(load_on_floor(world, tower[0], 16) / before, 1, 0.05);
}

TEST(Tiers, tier_falls_back_within_a_second_after_removing_the_upper_half) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const std::vector<BodyId> tower = add_tower(world, 60, 0);
    run(world, 5);
    ASSERT_EQ(world.profile().bodies_tall, 60);
    for (int k = 59; k >= 30; k--) must(world.destroy_body(tower[static_cast<std::size_t>(k)]));
    int steps = 0;
    double highest = 0;
    while (world.profile().bodies_tall != 0 && steps < 60) {
        must(world.step(1.0 / 60));
        steps++;
    }
    EXPECT_GE(steps, 24);  // not at once
    EXPECT_LT(steps, 60);
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        highest = maximum(highest, position_of(world, tower[29]).y);
    }
    EXPECT_NEAR(highest, 29.5, 0.01);
}

// Each of them joins the tower as an island that has not been looked at for long.
TEST(Tiers, falling_bodies_do_not_keep_the_tall_tier) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const std::vector<BodyId> tower = add_tower(world, 60, 0);
    run(world, 5);
    ASSERT_EQ(world.profile().bodies_tall, 60);
    for (int k = 59; k >= 20; k--) must(world.destroy_body(tower[static_cast<std::size_t>(k)]));
    int steps = 0;
    for (; world.profile().bodies_tall != 0 && steps < 120; steps++) {
        if (steps % 10 == 0)
            add(world, {.geometry = Box{{0.05, 0.05, 0.05}},
                        .position = {-0.4 + 0.08 * (steps / 10), 20.1, 0}});
        must(world.step(1.0 / 60));
    }
    EXPECT_LT(steps, 60);
}

TEST(Tiers, five_light_boxes_carry_five_boxes_of_100_times_their_mass_for_20_s) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 10; k++)
        boxes.push_back(
            add(world, {.position = {0, 0.5 + k, 0}, .density = k < 5 ? 1000.0 : 100000.0}));
    run(world, 20);
    EXPECT_EQ(world.profile().bodies_direct, 10);
    EXPECT_NEAR(position_of(world, boxes.back()).y, 9.5, 1e-4);
}

TEST(Tiers, light_box_on_a_heavy_box_is_not_a_heavy_load) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}, .density = 200000});
    add(world, {.position = {0, 1.5, 0}});
    run(world, 0.5);
    EXPECT_EQ(world.profile().bodies_in_solver, 2);
    EXPECT_EQ(world.profile().bodies_heavy, 0);
}

TEST(Tiers, island_coupled_to_a_tower_shares_its_tier_until_separated) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add_tower(world, 60, 0);
    // 10 mm beside it: near enough for manifolds, too far to touch.
    const std::vector<BodyId> near = add_tower(world, 3, 1.01);
    run(world, 0.5);
    EXPECT_EQ(world.islands().size(), 2u);
    EXPECT_EQ(world.profile().bodies_tall, 63);
    for (const BodyId body : near) must(world.destroy_body(body));
    add_tower(world, 3, 5);
    run(world, 0.5);
    EXPECT_EQ(world.profile().bodies_tall, 60);
}

TEST(Tiers, saved_tower_continues_bit_identically) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add_tower(world, 45, 0);
    run(world, 1);
    ASSERT_EQ(world.profile().bodies_tall, 45);
    World copy = must(load(save(world)));
    run(world, 0.5);
    run(copy, 0.5);
    EXPECT_EQ(copy.profile().bodies_tall, 45);
    EXPECT_EQ(state_hash(world), state_hash(copy));
}

}  // namespace
}  // namespace jostle::test
