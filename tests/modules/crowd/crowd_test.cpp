// SPDX-License-Identifier: MIT
//
// Agents, their bodies, goals and walls.
#include "jostle/modules/crowd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/modules/character.h"
#include "tests/modules/crowd/people.h"

namespace jostle::modules {
namespace {

using physics::BodyType;
using physics::ErrorCode;
using physics::Vec3;
using testing::HasSubstr;

TEST(Crowd, errors_name_the_field_and_the_range) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto error = [&](const AgentDef& def) { return crowd.add(world, def).error().message; };
    EXPECT_THAT(error({.radius = 0}), HasSubstr("radius is 0; it must be from 0.05 to 5"));
    EXPECT_THAT(error({.speed = 3}), HasSubstr("max_speed is 2; it must be from 3 to 100"));
    EXPECT_THAT(error({.position = {0, 2e6, 0}}), HasSubstr("position.y is 2000000"));
    EXPECT_THAT(error({.kind = AgentKind::flyer}), HasSubstr("flock is 0; there are 0 flocks"));
    EXPECT_THAT(error({.destination = to_goal(0)}), HasSubstr("destination: goal is 0"));
    EXPECT_THAT(crowd.set_settings({.neighbors = 0}).error().message,
                HasSubstr("neighbors is 0; it must be from 1 to 16"));
    EXPECT_THAT(crowd.set_routes({{}, {1e4, 1e4}, 0.05}).error().message,
                HasSubstr("it must have at most 131072"));
    EXPECT_THAT(crowd.add_goal({}).error().message, HasSubstr("areas has 0 elements"));
    EXPECT_EQ(crowd.alarm({}, -1).error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(crowd.add_threat(world, {.radius = 1}).error().code, ErrorCode::not_found);
    EXPECT_TRUE(crowd.ids().empty());
}

TEST(Crowd, static_bodies_and_bodies_of_other_agents_are_rejected) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto rock = add_person(world, {}, BodyType::static_body);
    EXPECT_THAT(crowd.add(world, {.body = rock}).error().message, HasSubstr("body is static"));
    const auto body = add_person(world, {3, 0, 0});
    const AgentId first = test::must(crowd.add(world, {.body = body}));
    EXPECT_EQ(crowd.agent_of(body), first);
    EXPECT_THAT(crowd.add(world, {.body = body}).error().message, HasSubstr("already belongs"));
}

TEST(Crowd, removed_agents_take_their_body_along_and_leave_stale_ids) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto body = add_person(world, {});
    const AgentId first = test::must(crowd.add(world, {.body = body}));
    test::must(crowd.remove(world, first));
    EXPECT_FALSE(world.contains(body));
    const AgentId second = test::must(crowd.add(world, {}));
    EXPECT_EQ(second.index, first.index);
    EXPECT_FALSE(crowd.contains(first));
    EXPECT_EQ(crowd.state(world, first).error().code, ErrorCode::not_found);
    // An agent ends with its body.
    const auto other = add_person(world, {3, 0, 0});
    const AgentId third = test::must(crowd.add(world, {.body = other}));
    test::must(world.destroy_body(other));
    test::must(world.step(1.0 / 60));
    EXPECT_FALSE(crowd.contains(third));
}

TEST(Crowd, agent_walks_at_its_speed_and_stops_at_its_point) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const AgentId id = test::must(crowd.add(
        world, {.position = {0, 1, 0}, .speed = 1.2, .destination = to_point({6, 0, 8})}));
    test::run(world, 4);
    EXPECT_NEAR(length(test::must(crowd.state(world, id)).velocity), 1.2, 1e-6);
    test::run(world, 10);
    const AgentState state = test::must(crowd.state(world, id));
    EXPECT_NEAR(state.position.x, 6, 0.01);
    EXPECT_EQ(state.position.y, 1);  // walkers keep their height
    EXPECT_TRUE(state.arrived);
    EXPECT_LT(length(state.velocity), 0.02);
}

TEST(Crowd, agents_follow_a_chain_of_goals_and_leave_at_the_last) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    test::must(crowd.add_goal({.areas = {{{5, 0}}}, .end = GoalEnd::next, .next = 1}));
    test::must(crowd.add_goal({.areas = {{{5, 5}}}, .end = GoalEnd::leave}));
    const auto body = add_person(world, {});
    const AgentId id = test::must(crowd.add(world, {.body = body, .destination = to_goal(0)}));
    test::run(world, 4);
    EXPECT_EQ(test::must(crowd.destination(id)).goal, 1u);
    test::run(world, 6);
    EXPECT_FALSE(crowd.contains(id));
    EXPECT_FALSE(world.contains(body));
    EXPECT_EQ(crowd.counts().left, 1u);
}

TEST(Crowd, follower_keeps_its_distance_from_its_leader) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto leader = add_person(world, {2, 0, 0});
    test::must(crowd.add(world, {.body = leader, .destination = moving({0, 0, 1})}));
    const AgentId id = test::must(
        crowd.add(world, {.speed = 2,
                          .max_speed = 3,
                          .destination = {.aim = Aim::follow, .body = leader, .distance = 1.5}}));
    test::run(world, 20);
    const AgentState state = test::must(crowd.state(world, id));
    const Vec3 offset = test::position_of(world, leader) - state.position;
    EXPECT_NEAR(length(Vec3{offset.x, 0, offset.z}), 1.5, 0.1);
    EXPECT_NEAR(state.velocity.z, 1, 0.05);
    EXPECT_TRUE(state.arrived);
}

// ---- bodies ----

// A kinematic agent pushes a crate at its own speed.
TEST(Crowd, kinematic_agent_pushes_a_crate) {
    physics::World world;
    test::add_floor(world, 0);
    Crowd& crowd = add_crowd(world);
    const auto crate =
        test::add(world, {.geometry = physics::Box{{0.4, 0.4, 0.4}}, .position = {1.5, 0.41, 0}});
    test::must(crowd.add(world, {.body = add_person(world, {}), .destination = moving({1, 0, 0})}));
    test::run(world, 4);
    EXPECT_NEAR(test::velocity_of(world, crate).x, 1, 0.05);
}

// A dynamic agent without ground friction that does not steer any more exchanges momentum with a
// ball: the contact acts on both.
TEST(Crowd, dynamic_agent_feels_the_reaction_of_what_it_hits) {
    physics::World world = test::make_world({.gravity = {}});
    Crowd& crowd = add_crowd(world);
    const auto person = add_person(world, {}, BodyType::dynamic);
    test::must(world.set_velocity(person, {2, 0, 0}, {}));
    const auto ball = test::must(world.create_body({.pose = {{1.2, 0.9, 0}, {}}},
                                                   {.geometry = physics::Sphere{0.3}, .mass = 75}));
    // Its acceleration is far below that of the impact.
    const AgentId id = test::must(
        crowd.add(world, {.body = person, .acceleration = 0.1, .destination = moving({2, 0, 0})}));
    test::run(world, 0.8);
    const double given = test::velocity_of(world, ball).x;
    const double left = test::velocity_of(world, person).x;
    EXPECT_NEAR(given + left, 2, 0.1);  // m/s of 75 kg each; steering adds up to 0.08
    EXPECT_GT(given, 0.9);
    EXPECT_TRUE(crowd.contains(id));
}

TEST(Crowd, dynamic_agent_walks_on_the_ground_upright) {
    physics::World world;
    test::add_floor(world, 0);
    Crowd& crowd = add_crowd(world);
    const auto person = add_person(world, {0, 0.01, 0}, BodyType::dynamic);
    test::must(crowd.add(world, {.body = person, .destination = moving({0, 0, 1.3})}));
    test::run(world, 3);
    EXPECT_NEAR(test::velocity_of(world, person).z, 1.3, 1e-3);
    EXPECT_NEAR(test::position_of(world, person).y, 0.9, 0.01);
    EXPECT_EQ(test::state_of(world, person).pose.rotation, physics::Quat{});
}

TEST(Crowd, dynamic_agent_in_the_air_does_not_steer) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto person = add_person(world, {0, 20, 0}, BodyType::dynamic);
    test::run(world, 0.3);  // falls at 3 m/s
    test::must(crowd.add(world, {.body = person, .destination = moving({0, 0, 1.3})}));
    test::run(world, 0.5);
    EXPECT_EQ(test::velocity_of(world, person).z, 0);
}

// A crowd of dynamic bodies that is squeezed against a wall: the contact solver bears the pressure.
TEST(Crowd, dynamic_agents_do_not_overlap_in_a_crush) {
    physics::World world;
    test::add_floor(world, 0);
    Crowd& crowd = add_crowd(world);
    std::vector<physics::BodyId> people;
    for (int k = 0; k < 60; k++) {
        const Vec3 at{0.55 * (k % 10), 0, 0.55 * (k / 10)};
        people.push_back(add_person(world, at, BodyType::dynamic, 0.25));
        test::must(crowd.add(
            world,
            {.body = people.back(), .radius = 0.25, .destination = to_point({2.5, 0, 1.4})}));
    }
    test::run(world, 10);
    EXPECT_LE(largest_overlap(positions_of(world), 0.25), 0.04 * 0.25);
}

TEST(Crowd, characters_receive_walking_controls) {
    physics::World world;
    test::add_floor(world);
    Crowd& crowd = add_crowd(world);  // before the characters, so that they walk in the same step
    auto owned = std::make_unique<Characters>();
    Characters& characters = *owned;
    test::must(world.add_module(std::move(owned)));
    const CharacterId hero = test::must(characters.add(world, {.feet = {0, 0.01, 0}}));
    const auto body = test::must(characters.state(world, hero)).body;
    test::must(crowd.add(world, {.body = body, .radius = 0.3, .destination = to_point({4, 0, 0})}));
    test::run(world, 6);
    EXPECT_NEAR(test::must(characters.state(world, hero)).feet.x, 4, 0.1);
    EXPECT_EQ(crowd.counts().arrived, 1u);
}

// ---- walls ----

TEST(Crowd, outline_of_a_body_stops_agents) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    const auto crate =
        test::add_static(world, {.geometry = physics::Box{{1, 1, 1}},
                                 .position = {5, 1, 0},
                                 .rotation = physics::from_axis_angle({0, 1, 0}, physics::pi / 4)});
    test::must(crowd.add_walls_of(world, crate));
    const AgentId id =
        test::must(crowd.add(world, {.position = {0, 0, 0}, .destination = moving({1, 0, 0})}));
    double nearest = 1e9;
    for (int k = 0; k < 600; k++) {
        test::must(world.step(1.0 / 60));
        const Vec3 p = test::must(crowd.state(world, id)).position;
        // In the axes of the square, which stands on a corner.
        const double u = std::abs(p.x - 5 + p.z) / std::sqrt(2.0),
                     v = std::abs(p.x - 5 - p.z) / std::sqrt(2.0);
        nearest = std::min(nearest, std::hypot(std::max(u - 1, 0.0), std::max(v - 1, 0.0)));
    }
    EXPECT_GE(nearest, 0.2 - 1e-3);
    EXPECT_GT(test::must(crowd.state(world, id)).position.x, 6);  // slid around the corner
    const auto plane = test::add_floor(world);
    EXPECT_THAT(crowd.add_walls_of(world, plane).error().message, HasSubstr("has no outline"));
}

TEST(Crowd, publishes_counts_and_points_of_agents_without_body) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    test::must(crowd.add(world, {.position = {1, 2, 3}}));
    test::must(crowd.add(world, {.body = add_person(world, {9, 0, 0})}));
    std::vector<physics::Vec3> points;
    physics::ChannelWriter writer(
        [](physics::BodyId) { return 0u; }, {},
        [&](std::uint32_t kind, std::uint32_t, const physics::PointObject& object) {
            EXPECT_EQ(kind, 1u);
            points.assign(object.positions.begin(), object.positions.end());
        });
    crowd.publish(world, writer);
    ASSERT_EQ(writer.channels().size(), 1u);
    EXPECT_THAT(writer.channels()[0].values, testing::ElementsAre(2, 0, 0, 0));
    EXPECT_THAT(points, testing::ElementsAre(physics::Vec3{1, 2, 3}));
}

}  // namespace
}  // namespace jostle::modules
