// SPDX-License-Identifier: MIT
//
// Coupled bodies share one group and one sleep state, and the coupling has no other effect.
#include "jostle/modules/island_coupling.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using test::add;
using test::must;

struct GroupProbe : StepListener {
    BodyId a, b;
    int together = 0, apart = 0;

    StepHooks hooks() const override { return {.substeps = true, .concurrent = true}; }
    void before_substep(SubstepContext& substep) override {
        if (substep.index() != 0 || !(substep.contains(a) || substep.contains(b))) return;
        (substep.contains(a) && substep.contains(b) ? together : apart)++;
    }
};

// Nine hundred crates on a floor form several groups; two of them are far apart.
TEST(IslandCoupling, coupled_bodies_share_one_island) {
    for (const bool coupled : {false, true}) {
        World world = test::make_world({});
        test::add_floor(world);
        std::vector<BodyId> crates;
        for (int k = 0; k < 900; k++)
            crates.push_back(add(world, {.position = {2.2 * (k % 30), 0.49, 2.2 * (k / 30)},
                                         .sleep_allowed = false}));
        GroupProbe probe;
        probe.a = crates.front();
        probe.b = crates.back();
        if (coupled) must(create_island_coupling(world, probe.a, probe.b));
        must(world.add_listener(probe));
        test::run(world, 1);
        if (coupled) {
            EXPECT_EQ(probe.together, 60);
            EXPECT_EQ(probe.apart, 0);
        } else {
            EXPECT_GT(probe.apart, 0);
        }
    }
}

TEST(IslandCoupling, coupling_applies_no_force) {
    World world = test::make_world({});
    const BodyId a = add(world, {.position = {0, 50, 0}, .velocity = {3, 0, 0}, .spin = {1, 2, 3}});
    const BodyId b = add(world, {.position = {0.5, 80, 0}, .velocity = {-1, 0, 2}});
    must(create_island_coupling(world, a, b));
    test::run(world, 1);
    EXPECT_NEAR(world.body(a)->linear_velocity.x, 3, 1e-12);
    EXPECT_NEAR(world.body(b)->linear_velocity.z, 2, 1e-12);
    EXPECT_NEAR(test::position_of(world, a).y, 50 - 0.5 * 9.81, 0.05);
}

TEST(IslandCoupling, coupled_bodies_sleep_and_wake_together) {
    World world = test::make_world({});
    test::add_floor(world);
    const BodyId a = add(world, {.position = {0, 0.5, 0}}),
                 b = add(world, {.position = {9, 0.5, 0}});
    must(create_island_coupling(world, a, b));
    test::run(world, 3);
    EXPECT_FALSE(world.body(a)->awake);
    EXPECT_FALSE(world.body(b)->awake);
    must(world.apply_impulse(a, {5000, 0, 0}, {0, 0.5, 0}));
    test::run(world, 0.1);
    EXPECT_TRUE(world.body(b)->awake);
}

}  // namespace
}  // namespace jostle::modules
