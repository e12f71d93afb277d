// SPDX-License-Identifier: MIT
//
// 465 boxes in 30 rows still stand after 33 seconds without the help of sleep.
#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Pyramid, with_465_boxes_stands_at_step_2000_without_sleeping) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> boxes;
    std::vector<Vec3> places;
    for (int i = 0; i < 30; i++)
        for (int j = 0; j < 30 - i; j++) {
            places.push_back({(j - (30 - i - 1) / 2.0) * 1.05, 0.5 + i, 0});
            boxes.push_back(add(world, {.position = places.back()}));
        }
    ASSERT_EQ(boxes.size(), 465u);
    for (int k = 0; k < 2000; k++) must(world.step(1.0 / 60));
    double worst = 0;
    for (std::size_t i = 0; i < boxes.size(); i++)
        worst = maximum(worst, length(position_of(world, boxes[i]) - places[i]));
    RecordProperty("worst_mm", std::to_string(worst * 1000));
    // At 8 sub-steps it leans by some centimetres; at 16 by two.
    EXPECT_LT(worst, 0.15);
    EXPECT_LT(absolute(position_of(world, boxes.back()).y - places.back().y), 0.01);
}

}  // namespace
}  // namespace jostle::test
