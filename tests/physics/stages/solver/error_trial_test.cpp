// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/error_trial.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Hears of sub-steps, and so keeps trials away.
class Listener final : public StepListener {
public:
    StepHooks hooks() const override { return {.substeps = true}; }
};

TEST(ErrorTrial, does_not_change_the_motion) {
    // Stacks, a rolling ball, and doors on hinges that lie on the floor. With a tolerance of 1 km
    // all is on the first rung after a second, and stays there.
    World world = make_world({.tolerance = 1000, .sleeping = false});
    add_floor(world);
    for (int k = 0; k < 12; k++) add(world, {.position = {2.0 * (k / 4), 0.5 + k % 4, 0}});
    add(world, {.geometry = Sphere{0.5}, .position = {0, 0.5, 5}, .velocity = {2, 0, 0}});
    const BodyId a = add(world, {.position = {0, 0.5, -5}}),
                 b = add(world, {.position = {1.1, 0.5, -5}});
    must(world.create_joint({.body_a = a,
                             .body_b = b,
                             .frame_a = {{0.55, 0, 0}, {}},
                             .frame_b = {{-0.55, 0, 0}, {}},
                             .kind = HingeJoint{}}));
    run(world, 1);
    for (const IslandSubsteps& e : world.island_substeps()) EXPECT_EQ(e.substeps, 2);
    World alone = must(load(save(world)));
    Listener listener;
    must(alone.add_listener(listener));
    std::int64_t tried = 0;
    for (int k = 0; k < 20; k++) {
        must(world.step(1.0 / 60));
        must(alone.step(1.0 / 60));
        tried += world.profile().trial_substeps;
        EXPECT_EQ(alone.profile().trial_substeps, 0);
    }
    EXPECT_GT(tried, 2 * 15);
    std::vector<BodyState> here, there;
    world.copy_bodies(here);
    alone.copy_bodies(there);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); k++) {
        EXPECT_EQ(here[k].pose.position, there[k].pose.position) << k;
        EXPECT_EQ(here[k].linear_velocity, there[k].linear_velocity) << k;
        EXPECT_EQ(here[k].angular_velocity, there[k].angular_velocity) << k;
    }
}

TEST(ErrorTrial, counts_a_fallback_joint_once) {
    // A slider beside a contact cannot be solved at once, whoever asks.
    World world =
        make_world({.tolerance = 1e-3, .sleeping = false, .joint_solver = JointSolver::direct});
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    must(world.create_joint({.body_b = box, .frame_a = {{0, 0.5, 0}, {}}, .kind = SliderJoint{}}));
    std::int64_t tried = 0;
    run(world, 0.2);
    for (int k = 0; k < 16; k++) {
        must(world.step(1.0 / 60));
        tried += world.profile().trial_substeps;
        EXPECT_EQ(world.profile().joints_direct_fallback, 1) << k;
    }
    EXPECT_GT(tried, 0);
}

TEST(ErrorTrial, error_per_second_sums_position_and_velocity_errors) {
    // A place that is 1 mm further at each of 60 steps; a velocity of 1 mm/s more each, which after
    // a second is 60 mm/s, and has led 30 mm away.
    EXPECT_NEAR(second_error(0.001, 0, 1.0 / 60, ErrorLife::lasting), 0.060, 1e-12);
    EXPECT_NEAR(second_error(0, 0.001, 1.0 / 60, ErrorLife::lasting), 0.030, 1e-12);
    EXPECT_LT(second_error(0, 0.001, 1.0 / 60, ErrorLife::damped), 0.010);
}

TEST(ErrorTrial, nan_is_the_largest_error) {
    Island island;
    note_error(island, 0.5);
    note_error(island, 0.2);
    EXPECT_EQ(island.error.estimate, 0.5);
    note_error(island, std::numeric_limits<double>::quiet_NaN());
    EXPECT_GT(island.error.estimate, 1e5);
    EXPECT_TRUE(island.error.fresh);
}

}  // namespace
}  // namespace jostle::test
