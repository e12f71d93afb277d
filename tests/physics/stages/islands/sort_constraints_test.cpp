// SPDX-License-Identifier: MIT
//
// Threads share the colours of a large island, whose lanes are sorted now and then.
#include <gtest/gtest.h>

#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

// 1440 boxes that touch their neighbours, put there in any order: 4000 manifolds and more.
World large_heap(int threads) {
    World world = make_world({.threads = threads, .sleeping = false});
    add_floor(world);
    for (int k = 0; k < 1440; k++) {
        const int at = k * 607 % 1440;
        add(world, {.geometry = Box{{0.25, 0.25, 0.25}},
                    .position = {at % 12 * 0.5, 0.25 + at / 144 * 0.5, at / 12 % 12 * 0.5},
                    .spin = {0.02 * (at % 5), 0, 0}});
    }
    return world;
}

TEST(LaneOrder, pile_with_shared_colours_is_bit_identical_for_1_to_4_threads) {
    World one = large_heap(1);
    run(one, 0.8);
    EXPECT_GT(one.profile().manifolds, 4000);
    for (const int threads : {2, 3, 4}) {
        World world = large_heap(threads);
        run(world, 0.8);
        EXPECT_EQ(world.profile().solver_tasks, 0);
        EXPECT_EQ(state_hash(one), state_hash(world))
            << threads << " threads: " << first_difference(one, world).value_or("");
    }
}

}  // namespace
}  // namespace jostle::test
