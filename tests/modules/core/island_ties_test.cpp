// SPDX-License-Identifier: MIT
#include "jostle/modules/island_ties.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/physics/module.h"
#include "jostle/physics/step_listener.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;

// Counts the groups that own the ties, per sub-step.
struct Owners : StepListener {
    IslandTies ties;
    int calls = 0, owned = 0, complete = 0;
    StepHooks hooks() const override { return {.substeps = true, .concurrent = false}; }
    void before_substep(SubstepContext& substep) override {
        calls++;
        if (!ties.owned_by(substep)) return;
        owned++;
        complete +=
            std::ranges::all_of(ties.bodies(), [&](BodyId body) { return substep.contains(body); });
    }
};

TEST(IslandTies, one_group_owns_all_tied_bodies) {
    World world = test::make_world();
    test::add_floor(world);
    std::vector<BodyId> bodies;
    for (int k = 0; k < 5; k++)  // two of them rest on the floor, the others fly
        bodies.push_back(test::add(world, {.position = {3.0 * k, k < 2 ? 0.5 : 5.0 + k, 0}}));
    Owners owners;
    test::must(owners.ties.update(world, bodies));
    EXPECT_EQ(world.joints().size(), 4u);
    test::must(world.add_listener(owners));
    for (int n = 0; n < 10; n++) test::must(world.step(1.0 / 60));
    EXPECT_GT(owners.owned, 0);
    EXPECT_EQ(owners.complete, owners.owned);
    EXPECT_EQ(world.islands().size(), 1u);
    test::must(world.remove_listener(owners));
}

TEST(IslandTies, change_the_world_only_with_the_bodies) {
    World world = test::make_world();
    const BodyId a = test::add(world, {.position = {0, 5, 0}});
    const BodyId b = test::add(world, {.position = {3, 5, 0}});
    IslandTies ties;
    const BodyId both[] = {a, b}, one[] = {a};
    test::must(ties.update(world, both));
    const std::vector<JointId> before = world.joints();
    test::must(ties.update(world, both));
    EXPECT_EQ(world.joints(), before);
    test::must(ties.update(world, one));  // tied to the world
    ASSERT_EQ(world.joints().size(), 1u);
    EXPECT_NE(world.joints(), before);
    test::must(ties.update(world, {}));
    EXPECT_TRUE(world.joints().empty());
    EXPECT_TRUE(ties.bodies().empty());
}

TEST(IslandTies, replace_ties_of_destroyed_bodies) {
    World world = test::make_world();
    std::vector<BodyId> bodies;
    for (int k = 0; k < 3; k++) bodies.push_back(test::add(world, {.position = {3.0 * k, 5, 0}}));
    IslandTies ties;
    test::must(ties.update(world, bodies));
    test::must(world.destroy_body(bodies[1]));
    EXPECT_FALSE(ties.update(world, bodies).ok());
    const BodyId rest[] = {bodies[0], bodies[2]};
    test::must(ties.update(world, rest));
    EXPECT_EQ(world.joints().size(), 1u);
}

// Module with ties as its state. A loaded state may name any joint.
struct TiesModule : Module {
    IslandTies ties;
    std::string_view tag() const override { return "ties"; }
    void visit(StateVisitor& v) override { ties.visit(v); }
};

TEST(IslandTies, destroy_no_joint_that_is_not_a_coupling) {
    World world = test::make_world();
    const BodyId a = test::add(world, {.position = {0, 5, 0}});
    const BodyId b = test::add(world, {.position = {3, 5, 0}});
    TiesModule module;
    const BodyId both[] = {a, b};
    test::must(module.ties.update(world, both));
    const std::vector<std::byte> saved = save_module(module);
    const JointId tie = world.joints().front();
    // In another world a ball joint has the id of the tie.
    World other = test::make_world();
    test::add(other, {.position = {0, 5, 0}});
    test::add(other, {.position = {3, 5, 0}});
    ASSERT_EQ(test::must(other.create_joint({.body_a = a, .body_b = b})), tie);
    TiesModule loaded;
    test::must(load_module(loaded, saved));
    loaded.ties.release(other);
    EXPECT_TRUE(other.contains(tie));
    module.ties.release(world);
    EXPECT_FALSE(world.contains(tie));
}

TEST(IslandTies, apply_no_force) {
    World world = test::make_world();
    const BodyId a = test::add(world, {.position = {0, 5, 0}});
    const BodyId b = test::add(world, {.position = {3, 5, 0}});
    test::must(world.set_velocity(a, {1, 0, 0}, {}));
    IslandTies ties;
    const BodyId both[] = {a, b};
    test::must(ties.update(world, both));
    for (int n = 0; n < 30; n++) test::must(world.step(1.0 / 60));
    EXPECT_NEAR(world.body(a)->linear_velocity.x, 1, 1e-6);
    EXPECT_NEAR(world.body(b)->linear_velocity.x, 0, 1e-6);
    EXPECT_NEAR(world.body(b)->linear_velocity.y, world.gravity().y * 0.5, 1e-4);
}

}  // namespace
}  // namespace jostle::modules
