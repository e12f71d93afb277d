// SPDX-License-Identifier: MIT
//
// Sub-steps by the time scale of the smallest body: usual bodies keep theirs, smaller ones and
// higher gravity take 3, 8 or 24 times as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId add_cube(World& world, double size, Vec3 at) {
    return add(world, {.geometry = Box{Vec3{.5, .5, .5} * size}, .position = at});
}

int substeps_at(const World& world, BodyId body) {
    const std::vector<IslandSubsteps> all = world.island_substeps();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const IslandSubsteps& i) { return i.body == body; });
    return found == all.end() ? 0 : found->substeps;
}

// Of a cube that rests on a floor, after its first step.
int first_substeps(double size, double gravity) {
    World world = make_world({.gravity = {0, -gravity, 0}});
    add_floor(world);
    const BodyId cube = add_cube(world, size, {0, 0.5 * size, 0});
    must(world.step(1.0 / 60));
    return substeps_at(world, cube);
}

TEST(SizeLevels, follow_the_root_of_gravity_over_size_from_the_first_step) {
    for (const double size : {0.06, 0.1, 1.0, 10.0}) EXPECT_EQ(first_substeps(size, 9.81), 8);
    EXPECT_EQ(first_substeps(1, 1.62), 8) << "the moon";
    EXPECT_EQ(first_substeps(1, 24.8), 8) << "Jupiter";
    EXPECT_EQ(first_substeps(0.01, 9.81), 24);
    EXPECT_EQ(first_substeps(0.002, 9.81), 64);
    EXPECT_EQ(first_substeps(1, 981), 24);
    EXPECT_EQ(first_substeps(0.1, 981), 64);
    EXPECT_EQ(first_substeps(0.01, 981), 192);
    EXPECT_EQ(first_substeps(100, 981), 8);
}

TEST(SizeLevels, are_chosen_per_group_of_touching_bodies) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId large = add_cube(world, 1, {0, 0.5, 0}),
                 small = add_cube(world, 0.01, {9, 5e-3, 0}),
                 below = add_cube(world, 1, {20, 0.5, 0});
    add_cube(world, 0.01, {20, 1.005, 0});
    run(world, 0.5);
    EXPECT_EQ(substeps_at(world, large), 4);
    EXPECT_EQ(substeps_at(world, small), 12);
    EXPECT_EQ(substeps_at(world, below), 12);
}

TEST(SizeLevels, fall_when_gravity_does_and_survive_saving) {
    World world = make_world({.gravity = {0, -981, 0}, .sleeping = false});
    add_floor(world);
    const BodyId cube = add_cube(world, 0.1, {0, 0.05, 0});
    run(world, 1);
    EXPECT_EQ(substeps_at(world, cube), 32);
    World copy = must(load(save(world)));
    for (World* each : {&world, &copy}) {
        must(each->set_gravity({0, -9.81, 0}));
        run(*each, 2);
    }
    EXPECT_EQ(substeps_at(world, cube), 4);
    EXPECT_EQ(state_hash(world), state_hash(copy));
}

// Batches that shared the work of threads become levels.
TEST(SizeLevels, do_not_change_the_sub_steps_of_other_islands) {
    World world = make_world({.threads = 4, .sleeping = false});
    add_floor(world);
    std::vector<BodyId> cubes;
    for (int i = 0; i < 900; i++)
        cubes.push_back(add_cube(world, 1, {3.0 * (i % 30), 0.5, 3.0 * (i / 30)}));
    run(world, 1);
    add_cube(world, 0.01, {-5, 0.005, 0});
    run(world, 0.5);
    for (const BodyId cube : cubes) ASSERT_EQ(substeps_at(world, cube), 4);
}

}  // namespace
}  // namespace jostle::test
