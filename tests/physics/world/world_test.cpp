// SPDX-License-Identifier: MIT
//
// A world counts its steps, may be moved, and may get other threads between two of them.
#include "jostle/physics/world.h"

#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(World, counts_steps_and_keeps_its_def) {
    World world = make_world({.gravity = {1, 2, 3}, .substeps = 5});
    EXPECT_EQ(world.step_count(), 0u);
    run(world, 0.5);
    EXPECT_EQ(world.step_count(), 30u);
    EXPECT_EQ(world.gravity(), (Vec3{1, 2, 3}));
    EXPECT_EQ(world.substeps(), 5);
}

// From 10 us to a quarter of a second.
TEST(World, step_out_of_range_changes_nothing) {
    World world = make_world();
    const BodyId box = add(world, {.position = {0, 5, 0}});
    for (const double dt : {9e-6, 0.2501, -1.0, 0.0}) {
        EXPECT_FALSE(world.step(dt).ok()) << dt;
        EXPECT_EQ(position_of(world, box).y, 5);
    }
    EXPECT_EQ(world.step_count(), 0u);
    must(world.step(1e-5));
    must(world.step(0.25));
    EXPECT_EQ(world.step_count(), 2u);
}

TEST(World, is_movable_with_all_its_content) {
    World first = make_world();
    const BodyId box = add(first, {.position = {0, 5, 0}});
    World second = std::move(first);
    run(second, 0.5);
    EXPECT_LT(position_of(second, box).y, 5);
    first = make_world();
    EXPECT_FALSE(first.contains(box));
}

TEST(World, thread_count_can_change_between_steps) {
    World one = make_world(), many = make_world();
    for (World* world : {&one, &many}) {
        add_floor(*world);
        for (int k = 0; k < 5; k++) add(*world, {.position = {0, 0.5 + k, 0}});
        run(*world, 0.2);
    }
    must(many.set_threads(3));
    EXPECT_FALSE(many.set_threads(0).ok());
    EXPECT_FALSE(many.set_threads(65).ok());
    run(one, 0.2);
    run(many, 0.2);
    EXPECT_EQ(state_hash(one), state_hash(many));
}

}  // namespace
}  // namespace jostle::test
