// SPDX-License-Identifier: MIT
//
// What comes to lie on what is a hundred times lighter has its sub-steps in the next step, not at
// the next look at all islands; what has firm ground, too, or is no heavier than that, does not ask
// for them.
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
        World world = make_world({.sleeping = false});
        add_floor(world);
        const BodyId light = add(world, {.position = {0, 0.5, 0}});
        run(world, 0.5 + delay / 60.0);
        const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 2e5});
        EXPECT_EQ(steps_until_heavy(world, load, light), 0) << "after " << delay;
    }
}

TEST(HeavyLoad, ignores_a_mass_ratio_of_fifty) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId light = add(world, {.position = {0, 0.5, 0}});
    const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 5e4});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

TEST(HeavyLoad, ignores_heavy_bodies_supported_by_the_floor) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId light = add(world, {.position = {1.01, 0.5, 0}, .velocity = {-0.5, 0, 0}});
    const BodyId load = add(world, {.position = {0, 0.5, 0}, .density = 2e5});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

}  // namespace
}  // namespace jostle::test
