// SPDX-License-Identifier: MIT
//
// A load on something lighter is solved directly before it touches it. Where that is not possible,
// as in a planar world, a load of a hundred times the mass gets more sub-steps in the next step,
// not at the next look at all islands; one that has firm ground, too, or less mass, does not need
// them.
#include "physics/src/stages/islands/island_stages.h"

#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Steps from the first touch with the light box to the first step with more sub-steps; -1: none in
// a second.
int steps_until_heavy(World& world, BodyId load, BodyId light) {
    int since = -1;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        if (world.profile().bodies_heavy > 0) return since;
        bool touch = since >= 0;
        for (const ContactInfo& c : world.contacts())
            touch = touch || ((c.body_a == load || c.body_b == load) &&
                              (c.body_a == light || c.body_b == light) && c.touching);
        if (touch) since++;
    }
    return -1;
}

TEST(HeavyLoad, is_detected_one_step_after_contact) {
    for (int delay = 0; delay < 8; delay++) {
        World world = make_world({.sleeping = false, .planar = true});
        add_floor(world);
        const BodyId light = add(world, {.position = {0, 0.5, 0}});
        run(world, 0.5 + delay / 60.0);
        const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 2e5});
        EXPECT_EQ(steps_until_heavy(world, load, light), 0) << "after " << delay;
    }
}

TEST(HeavyLoad, ignores_a_mass_ratio_of_fifty) {
    World world = make_world({.sleeping = false, .planar = true});
    add_floor(world);
    const BodyId light = add(world, {.position = {0, 0.5, 0}});
    const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 5e4});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

TEST(HeavyLoad, ignores_heavy_bodies_supported_by_the_floor) {
    World world = make_world({.sleeping = false, .planar = true});
    add_floor(world);
    const BodyId light = add(world, {.position = {1.01, 0.5, 0}, .velocity = {-0.5, 0, 0}});
    const BodyId load = add(world, {.position = {0, 0.5, 0}, .density = 2e5});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

TEST(HeavyLoad, is_solved_directly_before_contact) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    run(world, 0.5);
    const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 2e4});
    int before = 0;
    double lowest = 1.52;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        if (k == 2) before = world.profile().bodies_direct;
        EXPECT_EQ(world.profile().direct_passes_unsolved, 0) << "step " << k;
        lowest = minimum(lowest, position_of(world, load).y);
    }
    EXPECT_EQ(before, 2) << "it falls for four steps";
    EXPECT_GT(lowest, 1.5 - 1e-4);
}

TEST(HeavyLoad, equal_and_lighter_loads_are_not_solved_directly) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int k = 0; k < 6; k++)
        add(world, {.position = {0, 0.5 + k, 0}, .density = k == 0 ? 2e5 : 1000.0});
    run(world, 0.5);
    EXPECT_EQ(world.profile().bodies_direct, 0);
}

TEST(HeavyLoad, islands_that_become_too_large_leave_the_direct_tier) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.geometry = Box{{2.5, 0.5, 2.5}}, .position = {0, 0.5, 0}, .density = 10});
    add(world, {.position = {0, 1.5, 0}, .density = 1e5});
    run(world, 0.5);
    ASSERT_EQ(world.profile().bodies_direct, 2);
    for (int k = 0; k < 81; k++)
        if (k != 40)
            add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                        .position = {-2 + 0.5 * (k % 9), 1.201, -2 + 0.5 * (k / 9)}});
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().bodies_direct, 0);
    EXPECT_GT(world.profile().bodies_heavy, 64);
}

TEST(HeavyLoad, bodies_with_joints_are_not_solved_directly) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId light = add(world, {.position = {0, 0.5, 0}});
    const BodyId load = add(world, {.position = {0, 1.5, 0}, .density = 2e5});
    run(world, 0.1);
    ASSERT_EQ(world.profile().bodies_direct, 2);
    must(world.create_joint({.body_a = light, .body_b = load, .kind = DistanceJoint{}}));
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().bodies_direct, 0);
}

}  // namespace
}  // namespace jostle::test
