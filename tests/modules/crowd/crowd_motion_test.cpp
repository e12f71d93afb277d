// SPDX-License-Identifier: MIT
//
// Crowds that cross each other: nobody overlaps, everybody arrives.
#include <gtest/gtest.h>

#include "tests/modules/crowd/people.h"

namespace jostle::modules {
namespace {

using physics::Vec3;

// Runs until all agents have arrived. Returns the largest overlap of two discs, m.
double run_until_arrived(physics::World& world, double radius, double seconds_max, int up = 1) {
    double overlap = 0;
    Crowd& crowd = crowd_of(world);
    for (int step = 0; step < seconds_max * 60; step++) {
        test::must(world.step(1.0 / 60));
        if (step % 6 == 0)
            overlap = std::max(overlap, largest_overlap(positions_of(world), radius, up));
        if (crowd.counts().arrived == crowd.counts().agents) return overlap;
    }
    return overlap;
}

// The complete case of 1,000 agents is crowd_circle of jostle-bench modules.
TEST(CrowdMotion, agents_on_a_circle_swap_places) {
    physics::World world;
    add_crowd(world);
    add_circle(world, 200, 27, 0.25);
    const double overlap = run_until_arrived(world, 0.25, 150);
    EXPECT_LE(overlap, 0.01 * 0.25);
    EXPECT_EQ(crowd_of(world).counts().arrived, 200u);
    RecordProperty("overlap_percent_of_radius", std::to_string(100 * overlap / 0.25));
    RecordProperty("seconds", std::to_string(world.time()));
}

// Two agents that meet head-on pass each other on the right.
TEST(CrowdMotion, head_on_agents_pass_on_the_right) {
    physics::World world;
    Crowd& crowd = add_crowd(world, {.noise = 0});
    const AgentId east =
        test::must(crowd.add(world, {.position = {-5, 0, 0}, .destination = to_point({5, 0, 0})}));
    test::must(crowd.add(world, {.position = {5, 0, 0}, .destination = to_point({-5, 0, 0})}));
    double side = 0;
    for (int k = 0; k < 600; k++) {
        test::must(world.step(1.0 / 60));
        const Vec3 p = test::must(crowd.state(world, east)).position;
        if (std::abs(p.x) < 0.2) side = p.z;
    }
    EXPECT_GT(side, 0.1);  // +z is on the right of +x
    EXPECT_EQ(crowd.counts().arrived, 2u);
}

// Adds `columns` x `rows` agents around a centre, who walk by an offset.
void add_block(physics::World& world, int columns, int rows, Vec3 center, Vec3 offset) {
    for (int k = 0; k < columns * rows; k++) {
        const Vec3 p = center + Vec3{0.7 * (k % columns - 0.5 * (columns - 1)), 0,
                                     0.7 * (k / columns - 0.5 * (rows - 1))};
        test::must(
            crowd_of(world).add(world, {.position = p, .destination = to_point(p + offset)}));
    }
}

TEST(CrowdMotion, two_lanes_of_200_cross_at_right_angles) {
    physics::World world;
    add_crowd(world);
    add_block(world, 40, 5, {-18, 0, 0}, {36, 0, 0});
    add_block(world, 5, 40, {0, 0, -18}, {0, 0, 36});
    const double overlap = run_until_arrived(world, 0.2, 60);
    EXPECT_LE(overlap, 0.01 * 0.2);
    EXPECT_EQ(crowd_of(world).counts().arrived, 400u);
    RecordProperty("seconds", std::to_string(world.time()));
}

TEST(CrowdMotion, two_lanes_of_200_pass_through_each_other) {
    physics::World world;
    add_crowd(world);
    add_block(world, 20, 10, {-12, 0, 0}, {24, 0, 0});
    add_block(world, 20, 10, {12, 0, 0}, {-24, 0, 0});
    const double overlap = run_until_arrived(world, 0.2, 120);
    EXPECT_LE(overlap, 0.01 * 0.2);
    EXPECT_EQ(crowd_of(world).counts().arrived, 400u);
    RecordProperty("seconds", std::to_string(world.time()));
}

// 60 agents leave a room through a door of 1.2 m and walk around a wall to the goal.
TEST(CrowdMotion, room_is_evacuated_through_its_door) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const physics::Vec2 corners[] = {{5, 0.6}, {5, 5}, {-5, 5}, {-5, -5}, {5, -5}, {5, -0.6}};
    for (int k = 0; k < 5; k++) test::must(crowd.add_wall(corners[k], corners[k + 1]));
    test::must(crowd.add_wall({8, -4}, {8, 4}));
    test::must(crowd.set_routes({{2, 0}, {12, 8}, 0.25, 0.25}));
    test::must(crowd.add_goal({.areas = {{{12, 0}, {0.5, 1}}}, .end = GoalEnd::leave}));
    for (int k = 0; k < 60; k++)
        test::must(crowd.add(world, {.position = {-4 + 0.9 * (k % 10), 0, -3 + 0.9 * (k / 10)},
                                     .destination = to_goal(0)}));
    double outside = 0;  // m, deepest position in a wall of the room
    for (int step = 0; step < 90 * 60 && crowd.counts().agents > 0; step++) {
        test::must(world.step(1.0 / 60));
        for (const Vec3 p : positions_of(world))
            if (std::abs(p.z) > 0.6 && p.x < 5.0)
                outside = std::max(outside, std::max(std::abs(p.z), std::abs(p.x)) - (5 - 0.2));
    }
    EXPECT_EQ(crowd.counts().left, 60u);
    EXPECT_LE(outside, 0.002 * 0.2);
    RecordProperty("seconds", std::to_string(world.time()));
}

TEST(CrowdMotion, planar_world_has_walkers_in_its_plane) {
    physics::World world = test::make_world({.gravity = {}, .planar = true});
    Crowd& crowd = add_crowd(world, {.vertical = true});
    for (int k = 0; k < 40; k++) {
        const auto turn = physics::sin_cos(2 * physics::pi * k / 40);
        const Vec3 p{8 * turn.cos, 8 * turn.sin, 0};
        const auto body = test::must(world.create_body(
            {.type = k % 2 ? physics::BodyType::dynamic : physics::BodyType::kinematic,
             .pose = {p, {}}},
            {.geometry = physics::Sphere{0.25}, .material = {.friction = 0}, .mass = 75}));
        test::must(crowd.add(world, {.body = body, .radius = 0.25, .destination = to_point(-p)}));
    }
    const double overlap = run_until_arrived(world, 0.25, 60, 2);
    EXPECT_EQ(crowd.counts().arrived, 40u);
    EXPECT_LE(overlap, 0.01 * 0.25);
}

}  // namespace
}  // namespace jostle::modules
