// SPDX-License-Identifier: MIT
//
// Panic: alarms, threats and blows, and how it spreads and ends.
#include <gtest/gtest.h>

#include "tests/modules/crowd/people.h"

namespace jostle::modules {
namespace {

using physics::Vec3;

// Agents that stand in a row along x, 0.8 m apart.
std::vector<AgentId> add_row(physics::World& world, int n) {
    std::vector<AgentId> ids;
    for (int k = 0; k < n; k++)
        ids.push_back(test::must(crowd_of(world).add(world, {.position = {0.8 * k, 0, 0}})));
    return ids;
}

TEST(Panic, agents_run_away_from_an_alarm_and_calm_down) {
    physics::World world;
    Crowd& crowd = add_crowd(world, {.panic_time = 3, .contagion = 0});
    const AgentId id = test::must(crowd.add(world, {.position = {1, 0, 0}}));
    const AgentId far = test::must(crowd.add(world, {.position = {8, 0, 0}}));
    test::must(crowd.alarm({0, 0, 0}, 3));
    test::run(world, 0.5);
    EXPECT_GT(test::must(crowd.state(world, id)).velocity.x, 2.5);
    EXPECT_EQ(test::must(crowd.state(world, far)).panic, 0);
    EXPECT_EQ(crowd.counts().panicked, 1u);
    test::run(world, 3);
    EXPECT_EQ(crowd.counts().panicked, 0u);
    EXPECT_LT(length(test::must(crowd.state(world, id)).velocity), 0.5);
}

TEST(Panic, spreads_to_neighbours_with_decreasing_strength) {
    physics::World world;
    Crowd& crowd = add_crowd(world, {.panic_time = 8, .contagion = 0.5});
    const auto ids = add_row(world, 30);
    test::must(crowd.alarm({-0.5, 0, 0}, 1));
    test::run(world, 0.2);
    EXPECT_GT(test::must(crowd.state(world, ids[0])).panic, 7);
    const double second = test::must(crowd.state(world, ids[1])).panic;
    EXPECT_GT(second, 3.5);
    EXPECT_LT(second, 4.1);
    EXPECT_EQ(test::must(crowd.state(world, ids[29])).panic, 0);
    test::run(world, 9);
    EXPECT_EQ(crowd.counts().panicked, 0u) << "panic ends with its source";
}

TEST(Panic, agents_flee_from_a_threat_that_moves) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto bull = test::must(
        world.create_body({.type = physics::BodyType::kinematic, .linear_velocity = {1, 0, 0}},
                          {.geometry = physics::Sphere{0.5}}));
    test::must(crowd.add_threat(world, {bull, 4}));
    const AgentId id = test::must(crowd.add(world, {.position = {6, 0, 0}}));
    for (int k = 0; k < 600; k++) {
        test::must(world.step(1.0 / 60));
        ASSERT_GT(
            length(test::must(crowd.state(world, id)).position - test::position_of(world, bull)),
            3.5);
    }
    EXPECT_GT(test::must(crowd.state(world, id)).position.x, 12);
}

TEST(Panic, blow_frightens_the_agent_that_it_hits) {
    physics::World world;
    test::add_floor(world, 0);
    Crowd& crowd = add_crowd(world, {.blow_speed = 2});
    const auto person = add_person(world, {}, physics::BodyType::dynamic);
    const AgentId id = test::must(crowd.add(world, {.body = person}));
    test::run(world, 0.5);
    EXPECT_EQ(test::must(crowd.state(world, id)).panic, 0);
    test::must(world.apply_impulse(person, {0, 0, 75 * 4}, {0, 0.9, 0}));
    test::run(world, 0.1);
    EXPECT_GT(test::must(crowd.state(world, id)).panic, 5);
    EXPECT_GT(test::must(crowd.state(world, id)).velocity.z, 2);
}

// Agents in panic still do not overlap.
TEST(Panic, stampede_does_not_overlap) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    for (int k = 0; k < 200; k++)
        test::must(crowd.add(
            world, {.position = {0.45 * (k % 20), 0, 0.45 * (k / 20)}, .slows_in_crowds = true}));
    test::must(crowd.alarm({-1, 0, 2}, 20));
    for (int k = 0; k < 300; k++) {
        test::must(world.step(1.0 / 60));
        ASSERT_LE(largest_overlap(positions_of(world), 0.2), 0.01 * 0.2);
    }
    EXPECT_EQ(crowd.counts().panicked, 200u);
}

}  // namespace
}  // namespace jostle::modules
