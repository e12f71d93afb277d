// SPDX-License-Identifier: MIT
//
// Bodies put into each other come apart calmly.
#include <gtest/gtest.h>

#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(DeepOverlap, five_boxes_at_half_pitch_part_below_five_metres_a_second) {
    World world = make_world();
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 5; i++) boxes.push_back(add(world, {.position = {0, 0.5 + 0.5 * i, 0}}));
    double fastest = 0, highest = 0;
    for (int k = 0; k < 300; k++) {
        must(world.step(1.0 / 60));
        for (const BodyId box : boxes) {
            fastest = maximum(fastest, length(velocity_of(world, box)));
            highest = maximum(highest, position_of(world, box).y);
        }
    }
    RecordProperty("max_speed", std::to_string(fastest));
    RecordProperty("highest_m", std::to_string(highest));
    EXPECT_LT(fastest, 5);
    EXPECT_LT(highest, 5.0);  // the fifth belongs at 4.5
    EXPECT_LT(world.summary().max_penetration, 0.01);
}

TEST(DeepOverlap, bodies_at_the_very_same_place_come_apart) {
    for (const Geometry& geometry :
         {Geometry{Sphere{0.5}}, Geometry{Capsule{0.3, 0.4}}, Geometry{Box{}}}) {
        World world = make_world({.gravity = {}});
        const BodyId a = add(world, {.geometry = geometry}), b = add(world, {.geometry = geometry});
        double fastest = 0;
        for (int k = 0; k < 240; k++) {
            must(world.step(1.0 / 60));
            fastest = maximum(fastest, length(velocity_of(world, a)));
        }
        const double apart = length(position_of(world, a) - position_of(world, b));
        EXPECT_GT(apart, 0.59) << "kind " << geometry.index();
        EXPECT_LT(fastest, 5) << "kind " << geometry.index();
    }
}

TEST(DeepOverlap, ball_pushed_into_the_ground_comes_up) {
    World world = make_world();
    add_floor(world);
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .position = {0, 0, 0}});
    run(world, 5);
    EXPECT_NEAR(position_of(world, ball).y, 0.5, 2e-3);
}

}  // namespace
}  // namespace jostle::test
