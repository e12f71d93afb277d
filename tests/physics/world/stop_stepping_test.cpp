// SPDX-License-Identifier: MIT
//
// A step that is told to end ends soon, and leaves a world that is whole.
#include <gtest/gtest.h>

#include "jostle/physics/serialization.h"
#include "tests/support/world_builder.h"

namespace jostle::physics {
namespace {

using test::add;
using test::must;

// Stops the step in its first sub-step.
struct Stopper final : StepListener {
    explicit Stopper(World& w) : world(w) {}
    StepHooks hooks() const override { return {.substeps = true}; }
    void after_substep(SubstepContext&) override {
        substeps++;
        world.stop_stepping();
    }

    World& world;
    int substeps = 0;
};

// Boxes that overlap, a chain, and a bullet on its way to a wall.
World crowded_world() {
    World world = test::make_world();
    test::add_floor(world);
    for (int i = 0; i < 40; i++) add(world, {.position = {0.3 * (i % 5), 0.5 + 0.2 * i, 0.2}});
    BodyId last = {};
    for (int i = 0; i < 6; i++) {
        const BodyId link = add(world, {.geometry = Sphere{0.2}, .position = {6.0 + i, 5, 0}});
        must(world.create_joint({.body_a = last,
                                 .body_b = link,
                                 .frame_a = {{i == 0 ? 5.5 : 0.5, i == 0 ? 5.0 : 0.0, 0}},
                                 .frame_b = {{-0.5, 0, 0}}}));
        last = link;
    }
    add(world,
        {.geometry = Box{{0.05, 2, 2}}, .position = {-6, 2, 0}, .type = BodyType::static_body});
    add(world, {.geometry = Sphere{0.1}, .position = {-2, 2, 0}, .velocity = {-300, 0, 0}});
    return world;
}

TEST(StopStepping, step_ends_after_the_current_substep) {
    World world = crowded_world();
    Stopper stopper(world);
    must(world.add_listener(stopper));
    const Status stepped = world.step(1.0 / 60);
    ASSERT_FALSE(stepped.ok());
    EXPECT_EQ(stepped.error().code, ErrorCode::aborted);
    const int groups_at_most = 12;
    EXPECT_LE(stopper.substeps, groups_at_most) << "of eight sub-steps each";
    EXPECT_EQ(world.step(1.0 / 60).error().code, ErrorCode::aborted) << "until it is allowed again";
    must(world.remove_listener(stopper));
    world.resume_stepping();
    for (int i = 0; i < 200; i++) must(world.step(1.0 / 60));
}

TEST(StopStepping, aborted_world_is_consistent) {
    for (int steps = 0; steps < 6; steps++) {
        World world = crowded_world();
        for (int i = 0; i < steps; i++) must(world.step(1.0 / 60));
        Stopper stopper(world);
        must(world.add_listener(stopper));
        EXPECT_FALSE(world.step(1.0 / 60).ok());
        // What is read is checked store by store.
        const World read = must(load(save(world)));
        EXPECT_EQ(read.bodies().size(), world.bodies().size());
    }
}

}  // namespace
}  // namespace jostle::physics
