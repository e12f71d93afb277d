// SPDX-License-Identifier: MIT
//
// What a step says of itself: every stage has a time or a reason why it had nothing to do.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

std::string why(const World& world, Stage stage) {
    const char* reason = world.profile().stage_skipped[static_cast<std::size_t>(stage)];
    return reason == nullptr ? "ran" : reason;
}

TEST(Profile, sleeping_world_skips_every_stage_with_a_reason) {
    World world = make_world();
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    ASSERT_EQ(world.profile().bodies_awake, 0);
    for (int k = 0; k < stage_count; k++) {
        const Stage stage = static_cast<Stage>(k);
        EXPECT_NE(why(world, stage), "ran") << stage_name(stage);
        EXPECT_EQ(world.profile().stage_ms[static_cast<std::size_t>(k)], 0) << stage_name(stage);
    }
    EXPECT_EQ(why(world, Stage::solve_constraints), "no awake bodies");
    EXPECT_EQ(world.profile().pairs, 1);
}

TEST(Profile, body_in_free_flight_skips_the_solver) {
    World world = make_world();
    add(world, {.position = {0, 100, 0}});
    run(world, 0.1);
    EXPECT_EQ(why(world, Stage::solve_constraints), "nothing touches and nothing is jointed");
    EXPECT_EQ(why(world, Stage::integrate_free), "ran");
    EXPECT_EQ(why(world, Stage::solve_continuous), "no body moved further than half its thickness");
    EXPECT_EQ(why(world, Stage::update_triggers), "no triggers");
    EXPECT_EQ(why(world, Stage::publish_events), "no events");
    EXPECT_GT(world.profile().step_ms, 0);
}

TEST(Profile, names_the_slowest_stage) {
    World world = make_world();
    add_floor(world);
    for (int k = 0; k < 50; k++) add(world, {.position = {0, 0.5 + k, 0}});
    run(world, 0.1);
    const StepProfile& profile = world.profile();
    const auto worst = static_cast<std::size_t>(profile.worst_stage);
    EXPECT_GT(profile.worst_stage_ms, 0);
    EXPECT_EQ(profile.worst_stage_ms, profile.stage_ms[worst]);
    EXPECT_EQ(profile.worst_stage_ms,
              *std::max_element(profile.stage_ms.begin(), profile.stage_ms.end()));
}

TEST(Profile, disabled_stages_report_a_reason) {
    World world = make_world({.sleeping = false, .continuous = false});
    add(world, {.velocity = {100, 0, 0}});
    run(world, 0.1);
    EXPECT_EQ(why(world, Stage::update_sleep), "sleeping is disabled");
    EXPECT_EQ(why(world, Stage::solve_continuous), "continuous collision is off");
}

}  // namespace
}  // namespace jostle::test
