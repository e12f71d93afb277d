// SPDX-License-Identifier: MIT
//
// A stack that loses its load does not jump: what contacts learned about the load must be forgotten
// at once.
#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// How far the highest of the lower boxes rises above its place, m, in the two seconds after the
// load went.
double rise_after_unloading(double load_density, double seconds_before, bool sleeping) {
    World world = make_world({.sleeping = sleeping});
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 10; i++)
        boxes.push_back(
            add(world, {.position = {0, 0.5 + i, 0}, .density = i < 5 ? 1000 : load_density}));
    run(world, seconds_before);
    for (std::size_t i = 5; i < 10; i++) must(world.destroy_body(boxes[i]));
    double rise = 0;
    for (int k = 0; k < 120; k++) {
        must(world.step(1.0 / 60));
        for (std::size_t i = 0; i < 5; i++)
            rise = maximum(rise, position_of(world, boxes[i]).y - 0.5 - static_cast<double>(i));
    }
    return rise;
}

TEST(Unloading, removing_half_a_stack_does_not_disturb_the_rest) {
    for (const double seconds : {0.2, 1.0, 5.0, 20.0}) {
        const double rise = rise_after_unloading(1000, seconds, false);
        RecordProperty("rise_mm_after_" + std::to_string(static_cast<int>(seconds * 10)),
                       std::to_string(rise * 1000));
        EXPECT_LT(rise, 0.003) << "after " << seconds << " s";
    }
}

TEST(Unloading, sleeping_stack_wakes_without_motion) {
    EXPECT_LT(rise_after_unloading(1000, 5, true), 0.003);
}

TEST(Unloading, removing_a_tenfold_load_does_not_disturb_the_rest) {
    const double rise = rise_after_unloading(10000, 5, false);
    RecordProperty("rise_mm", std::to_string(rise * 1000));
    EXPECT_LT(rise, 0.001);
}

TEST(Unloading, removing_a_hundredfold_load_does_not_throw_up_its_support) {
    const double rise = rise_after_unloading(100000, 5, false);
    RecordProperty("rise_mm", std::to_string(rise * 1000));
    EXPECT_LT(rise, 0.01);
}

}  // namespace
}  // namespace jostle::test
