// SPDX-License-Identifier: MIT
//
// Scenes that solvers are known to lose: tall stacks, a thousandfold load, thin plates, leaning
// cards.
#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Runs, sleeping off, and says how far the worst body ended from its place, m.
double worst_after(World& world, double seconds) {
    std::vector<BodyState> before, after;
    world.copy_bodies(before);
    run(world, seconds);
    world.copy_bodies(after);
    double worst = 0;
    for (std::size_t i = 0; i < before.size(); i++)
        worst = maximum(worst, length(after[i].pose.position - before[i].pose.position));
    testing::Test::RecordProperty("worst_mm", std::to_string(worst * 1000));
    return worst;
}

TEST(HardScenes, stack_of_fifty_boxes_stands_for_20_s) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int i = 0; i < 50; i++) add(world, {.position = {0, 0.5 + i, 0}});
    EXPECT_LT(worst_after(world, 20), 0.01);
}

TEST(HardScenes, load_of_1000_times_the_mass_is_carried) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}, .density = 1});
    add(world, {.position = {0, 1.5, 0}, .density = 1000});
    EXPECT_LT(worst_after(world, 10), 0.002);
}

TEST(HardScenes, stack_of_twenty_1_cm_plates_stands) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int i = 0; i < 20; i++)
        add(world, {.geometry = Box{{0.1, 0.005, 0.1}},
                    .position = {0, 0.005 + 0.01 * i, 0},
                    .density = 250});
    EXPECT_LT(worst_after(world, 5), 0.006);
}

// Two cards at 20 degrees from upright lean on each other.
void lean_cards(World& world, double friction) {
    add_floor(world, friction);
    const double tilt = 20 * pi / 180;
    const SinCos a = sin_cos(tilt);
    for (const double side : {-1.0, 1.0})
        add(world,
            {.geometry = Box{{0.01, 0.5, 0.4}},
             .position = {side * (0.5 * a.sin + 0.01 * a.cos), 0.5 * a.cos + 0.01 * a.sin, 0},
             .rotation = from_rotation_vector({0, 0, side * tilt}),
             .friction = friction});
}

TEST(HardScenes, leaning_cards_stand_on_rough_ground) {
    World world = make_world({.sleeping = false});
    lean_cards(world, 0.6);
    EXPECT_LT(worst_after(world, 10), 0.001);
}

TEST(HardScenes, leaning_cards_slip_on_smooth_ground) {
    World world = make_world({.sleeping = false});
    lean_cards(world, 0.17);  // below tan(20) / 2
    EXPECT_GT(worst_after(world, 10), 0.1);
}

}  // namespace
}  // namespace jostle::test
