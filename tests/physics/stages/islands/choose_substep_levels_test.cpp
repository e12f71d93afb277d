// SPDX-License-Identifier: MIT
//
// Sub-steps by tolerance: who needs more has more, nobody else, and the budget is kept.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A chain of `links` that hangs from the world and swings, whose last link weighs `ratio` as much
// as the others.
std::vector<BodyId> add_chain(World& world, double x, int links, double ratio) {
    std::vector<BodyId> chain;
    BodyId above{};
    for (int k = 0; k < links; k++) {
        const BodyId link = add(world, {.geometry = Box{{0.25, 0.05, 0.05}},
                                        .position = {x + 0.25 + 0.5 * k, 20, 0},
                                        .density = k + 1 == links ? 1000 * ratio : 1000});
        const Transform left{{-0.25, 0, 0}, {}}, right{{0.25, 0, 0}, {}};
        if (k == 0)
            must(
                world.create_joint({.body_b = link, .frame_a = {{x, 20, 0}, {}}, .frame_b = left}));
        else
            must(world.create_joint(
                {.body_a = above, .body_b = link, .frame_a = right, .frame_b = left}));
        chain.push_back(above = link);
    }
    return chain;
}

const IslandSubsteps& of(const std::vector<IslandSubsteps>& island_substeps, BodyId body) {
    return *std::find_if(island_substeps.begin(), island_substeps.end(),
                         [&](const IslandSubsteps& e) { return e.body == body; });
}

World make_mixed_world(double tolerance, std::int64_t budget = 0, int threads = 1) {
    return make_world(
        {.tolerance = tolerance, .substep_budget = budget, .threads = threads, .sleeping = false});
}

TEST(SubstepLevels, resting_boxes_take_two_substeps_and_a_swinging_chain_takes_more) {
    World world = make_mixed_world(1e-3);
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 20; k++) boxes.push_back(add(world, {.position = {-2.0 * k, 0.5, 0}}));
    const BodyId link = add_chain(world, 10, 10, 100).front();
    run(world, 1);
    const std::vector<IslandSubsteps> island_substeps = world.island_substeps();
    ASSERT_EQ(island_substeps.size(), 21u);
    for (const BodyId box : boxes) {
        EXPECT_EQ(of(island_substeps, box).substeps, 2);
        EXPECT_LT(of(island_substeps, box).error, 1e-3);
    }
    EXPECT_GE(of(island_substeps, link).substeps, 16);
    EXPECT_TRUE(of(island_substeps, link).direct);
    EXPECT_EQ(of(island_substeps, link).joints, 10);
}

TEST(SubstepLevels, sliding_distance_is_within_the_tolerance) {
    // v^2 / (2 mu g) = 4.247 m, after 1.7 s. Floats leave 2 mm of it, with 64 sub-steps all along.
    double substeps_before = 0;
    for (const double tolerance : {5e-2, 1e-2, 2e-3}) {
        World world = make_mixed_world(tolerance);
        add_floor(world, 0.3);
        const BodyId box = add(world, {.geometry = Box{{0.1, 0.1, 0.1}},
                                       .position = {0, 0.1, 0},
                                       .velocity = {5, 0, 0},
                                       .friction = 0.3});
        double substeps = 0;
        for (int k = 0; k < 120; k++) {
            must(world.step(1.0 / 60));
            substeps += static_cast<double>(world.profile().body_substeps);
        }
        const double way = must(world.body(box)).pose.position.x;
        EXPECT_NEAR(way, 25 / (2 * 0.3 * 9.81), 1.7 * tolerance + 0.002) << tolerance;
        EXPECT_GT(substeps, substeps_before);
        substeps_before = substeps;
    }
}

TEST(SubstepLevels, stack_of_ten_does_not_sway_at_any_tolerance) {
    // With two sub-steps it did, from nothing, within two seconds: nobody saw it coming.
    for (const double tolerance : {1.0, 1e-2, 1e-3}) {
        World world = make_mixed_world(tolerance);
        add_floor(world);
        std::vector<BodyId> boxes;
        for (int k = 0; k < 10; k++) boxes.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
        run(world, 10);
        const BodyState top = must(world.body(boxes.back()));
        EXPECT_LT(length(top.pose.position - Vec3{0, 9.5, 0}), 0.002) << tolerance;
        EXPECT_LT(length(top.linear_velocity), 1e-3) << tolerance;
        EXPECT_EQ(world.island_substeps()[0].substeps, 6) << tolerance;
    }
}

TEST(SubstepLevels, budget_lowers_the_least_affected_islands_first) {
    World world = make_mixed_world(1e-4, 400);
    add_floor(world);
    const BodyId heavy = add_chain(world, 10, 10, 100).front();
    for (int k = 0; k < 10; k++)
        add(world,
            {.geometry = Sphere{0.5}, .position = {-2.0 * k, 0.5, 0}, .velocity = {0, 0, 3}});
    int kept = 0;
    for (int k = 0; k < 120; k++) {
        must(world.step(1.0 / 60));
        if (k >= 20 && world.profile().body_substeps <= 400) kept++;
    }
    EXPECT_EQ(kept, 100);
    const std::vector<IslandSubsteps> island_substeps = world.island_substeps();
    EXPECT_GE(of(island_substeps, heavy).target_substeps, of(island_substeps, heavy).substeps);
    for (const IslandSubsteps& e : island_substeps)
        EXPECT_LE(e.error, of(island_substeps, heavy).error);
}

TEST(SubstepLevels, no_error_is_measured_without_a_tolerance) {
    World world = make_world({.substep_budget = 5, .sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    for (int k = 0; k < 20; k++) {
        must(world.step(1.0 / 60));
        EXPECT_EQ(world.profile().trial_substeps, 0);
    }
    ASSERT_EQ(world.island_substeps().size(), 1u);
    EXPECT_EQ(world.island_substeps()[0].error, 0);
    EXPECT_EQ(world.island_substeps()[0].substeps, 8);
    EXPECT_EQ(world.profile().body_substeps, 8);
}

// Boxes fall in a heap beside a chain.
World make_busy_world(int threads) {
    World world = make_mixed_world(1e-3, 30000, threads);
    add_floor(world);
    for (int k = 0; k < 200; k++)
        add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                    .position = {0.41 * (k % 5), 0.3 + 0.45 * (k / 25), 0.41 * (k / 5 % 5)}});
    add_chain(world, 10, 10, 100);
    return world;
}

TEST(SubstepLevels, are_bit_identical_for_one_two_and_four_threads) {
    std::uint64_t hashes[3] = {};
    const int threads[3] = {1, 2, 4};
    for (int k = 0; k < 3; k++) {
        World world = make_busy_world(threads[k]);
        run(world, 1);
        hashes[k] = state_hash(world);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(SubstepLevels, world_saved_between_two_measurements_continues_identically) {
    World world = make_busy_world(1);
    run(world, 0.5);
    World copy = must(load(save(world)));
    EXPECT_EQ(copy.tolerance(), 1e-3);
    EXPECT_EQ(copy.substep_budget(), 30000);
    for (int k = 0; k < 40; k++) {
        must(world.step(1.0 / 60));
        must(copy.step(1.0 / 60));
        ASSERT_EQ(state_hash(world), state_hash(copy)) << k;
    }
}

}  // namespace
}  // namespace jostle::test
