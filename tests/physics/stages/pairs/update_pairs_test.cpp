// SPDX-License-Identifier: MIT
//
// Which shapes become pairs.
#include "physics/src/stages/stages.h"

#include <gtest/gtest.h>

#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// After the first step.
int pairs_of(World& world) {
    must(world.step(1.0 / 60));
    return world.profile().pairs;
}

TEST(UpdatePairs, overlapping_fat_boxes_become_pairs) {
    World near = make_world({.gravity = {}}), far = make_world({.gravity = {}});
    for (World* world : {&near, &far}) add(*world, {});
    add(near, {.position = {1.07, 0, 0}});
    add(far, {.position = {1.09, 0, 0}});
    EXPECT_EQ(pairs_of(near), 1) << "4 cm on each side";
    EXPECT_EQ(pairs_of(far), 0);
}

TEST(UpdatePairs, plane_pairs_with_shapes_it_reaches) {
    World world = make_world({.gravity = {}});
    add_floor(world);
    add(world, {.position = {100, 0.52, 0}});
    add(world, {.position = {0, 0.6, 0}});
    EXPECT_EQ(pairs_of(world), 1);
}

TEST(UpdatePairs, filtered_shapes_never_pair) {
    World world = make_world({.gravity = {}});
    for (int k = 0; k < 2; k++) {
        add_static(world, {.position = {0, 0.1 * k, 0}});
        add(world, {.position = {50, 0.1 * k, 0}, .type = BodyType::kinematic});
    }
    EXPECT_EQ(pairs_of(world), 0) << "nothing moves them by force";
    const BodyId body = add(world, {.position = {100, 0, 0}});
    must(world.create_shape(body, {.geometry = Sphere{2}}));
    EXPECT_EQ(pairs_of(world), 0) << "of one body";
    must(world.create_body({.pose = {.position = {100, 0, 0}}},
                           {.geometry = Sphere{0.1}, .filter = {.mask = 0}}));
    EXPECT_EQ(pairs_of(world), 0) << "its mask lets it see nobody";
    must(world.create_body({.type = BodyType::kinematic, .pose = {.position = {100, 0, 0}}},
                           {.geometry = Sphere{3}, .trigger = true}));
    EXPECT_EQ(pairs_of(world), 0) << "triggers touch nothing";
    const BodyId arm = must(world.create_body({.pose = {.position = {100, 1, 0}}}));
    must(world.create_joint({.body_a = body, .body_b = arm}));
    must(world.create_shape(arm, {.geometry = Sphere{1}}));
    EXPECT_EQ(pairs_of(world), 0) << "a joint holds them";
}

TEST(UpdatePairs, creates_each_pair_once_in_shape_order) {
    World world = make_world({.gravity = {}});
    for (int k = 0; k < 4; k++) add(world, {.position = {0.3 * k, 0.3 * k, 0}});
    EXPECT_EQ(pairs_of(world), 6);
    const WorldState& state = state_of(world);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Contact& c : state.contacts.contacts) pairs.emplace_back(c.shape_a, c.shape_b);
    EXPECT_EQ(pairs, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{
                         {0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
    must(world.set_material({0, 1}, {}));
    EXPECT_EQ(pairs_of(world), 6);
}

// `count` balls at one place above a floor that is added last, so that its pairs come last.
World crowd(int count, const WorldDef& def) {
    World world = make_world(def);
    for (int k = 0; k < count; k++)
        must(world.create_body({.pose = {.position = {0, 0.52, 0}}}, {.geometry = Sphere{0.5}}));
    add_static(world, {.position = {0, -0.5, 0}});
    return world;
}

TEST(UpdatePairs, limit_skips_pairs_of_dynamic_bodies_first) {
    World world = crowd(400, {.max_pairs_per_shape = 1});
    EXPECT_EQ(pairs_of(world), 4096 + 401);
    const int skipped = world.profile().pairs_skipped, excess = 400 * 399 / 2 + 400 - 4497;
    EXPECT_TRUE(excess <= skipped && skipped <= 2 * (excess + 400)) << skipped << " of " << excess;
    int on_floor = 0;
    for (const Contact& c : state_of(world).contacts.contacts)
        on_floor += c.shape_a == 400 || c.shape_b == 400;
    EXPECT_EQ(on_floor, 400);
    run(world, 1);
    std::vector<BodyState> bodies;
    world.copy_bodies(bodies);
    for (std::size_t k = 0; k < 400; k++) EXPECT_GT(bodies[k].pose.position.y, 0.4) << k;
    must(world.set_max_pairs_per_shape(0));
    EXPECT_EQ(world.max_pairs_per_shape(), 0);
    EXPECT_FALSE(world.set_max_pairs_per_shape(-1).ok());
    EXPECT_FALSE(World::create({.max_pairs_per_shape = 1000001}).ok());
}

TEST(UpdatePairs, skipped_pairs_do_not_depend_on_threads_or_saving) {
    World one = crowd(600, {.max_pairs_per_shape = 2}),
          four = crowd(600, {.max_pairs_per_shape = 2, .threads = 4});
    for (int k = 0; k < 40; k++) {
        must(one.step(1.0 / 60));
        must(four.step(1.0 / 60));
        if (k == 5) four = must(load(save(four)));
        ASSERT_EQ(state_hash(one), state_hash(four)) << k;
    }
}

TEST(UpdatePairs, new_neighbour_wakes_a_sleeping_body) {
    World world = make_world();
    add_floor(world);
    add(world, {.position = {50, 0.5, 0}, .sleep_allowed = false});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    ASSERT_FALSE(state_of(world, box).awake);
    add_static(world, {.position = {0.9, 0.5, 0}});
    must(world.step(1.0 / 60));
    EXPECT_TRUE(state_of(world, box).awake);
    ASSERT_EQ(world.events().woke.size(), 1u);
    EXPECT_EQ(world.events().woke[0], box);
}

}  // namespace
}  // namespace jostle::test
