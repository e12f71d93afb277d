// SPDX-License-Identifier: MIT
//
// Bodies come, are read and go with all that hangs on them.
#include <gtest/gtest.h>

#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(CreateBody, uses_the_pose_and_content_of_the_def) {
    World world = make_world();
    const Quat turned = from_axis_angle({0, 1, 0}, 0.5);
    const BodyId body = must(world.create_body({.pose = {{1, 2, 3}, turned},
                                                .linear_velocity = {4, 5, 6},
                                                .angular_velocity = {7, 8, 9},
                                                .locks = lock_x | lock_rotation_y,
                                                .user_data = 77},
                                               {.geometry = Box{{1, 1, 1}}}));
    const BodyState state = state_of(world, body);
    EXPECT_EQ(state.id, body);
    EXPECT_EQ(state.type, BodyType::dynamic);
    EXPECT_TRUE(near(state.pose.position, {1, 2, 3}, 1e-12));
    EXPECT_EQ(state.pose.rotation, turned);
    EXPECT_EQ(state.linear_velocity, (Vec3{0, 5, 6})) << "what is locked does not move";
    EXPECT_EQ(state.angular_velocity, (Vec3{7, 0, 9}));
    EXPECT_EQ(state.mass, 8000);
    EXPECT_TRUE(state.awake);
    EXPECT_EQ(state.user_data, 77u);
}

TEST(CreateBody, bodies_are_listed_by_index) {
    World world = make_world();
    std::vector<BodyId> made;
    for (int k = 0; k < 4; k++) made.push_back(add(world, {.position = {3.0 * k, 0, 0}}));
    must(world.destroy_body(made[1]));
    EXPECT_EQ(world.bodies(), (std::vector{made[0], made[2], made[3]}));
    const BodyId next = add(world, {.position = {99, 0, 0}});
    EXPECT_EQ(next.index, made[1].index) << "the lowest that is free";
    EXPECT_NE(next, made[1]);
    std::vector<BodyState> states(17);
    world.copy_bodies(states);
    ASSERT_EQ(states.size(), 4u);
    EXPECT_EQ(states[1].id, next);
    EXPECT_EQ(states[1].pose.position.x, 99);
}

TEST(CopyAwakeBodies, returns_bodies_that_a_step_can_move) {
    World world = make_world();
    add_floor(world);
    const BodyId sleeper = add(world, {.position = {0, 0.5, 0}});
    const BodyId lift = add(world, {.position = {9, 3, 0}, .type = BodyType::kinematic});
    const BodyId faller = add(world, {.position = {3, 50, 0}});
    run(world, 2);
    std::vector<BodyState> awake(5);
    world.copy_awake_bodies(awake);
    std::ranges::sort(awake, {}, &BodyState::id);
    ASSERT_EQ(awake.size(), 2u);
    EXPECT_EQ(awake[0].id, lift);
    EXPECT_EQ(awake[1].id, faller);
    EXPECT_FALSE(must(world.body(sleeper)).awake);
}

TEST(StaticRevision, changes_when_a_call_moves_a_static_or_sleeping_body) {
    World world = make_world();
    const BodyId floor = add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    const std::uint64_t before = world.static_revision();
    must(world.set_pose(box, {{5, 0.5, 0}, {}}));
    run(world, 1);
    EXPECT_EQ(world.static_revision(), before) << "it woke, and is among the awake";
    must(world.set_pose(floor, {{0, -1, 0}, {}}));
    EXPECT_NE(world.static_revision(), before);
    const std::uint64_t moved = world.static_revision();
    must(world.set_pose(box, {{7, -0.5, 0}, {}}));
    must(world.set_awake(box, false));
    EXPECT_NE(world.static_revision(), moved) << "moved and put to sleep between two steps";
}

// A body on the floor with a joint to another and a trigger: nothing of it is left.
TEST(DestroyBody, removes_shapes_contacts_joints_and_island) {
    World world = make_world();
    const BodyId floor = add_floor(world);
    const BodyId body = add(world, {.position = {0, 0.5, 0}}),
                 other = add(world, {.position = {3, 0.5, 0}});
    must(world.create_shape(body, {.geometry = Sphere{2}, .trigger = true}));
    const JointId joint = must(world.create_joint({.body_a = body,
                                                   .body_b = other,
                                                   .frame_a = {.position = {1.5, 0, 0}},
                                                   .frame_b = {.position = {-1.5, 0, 0}}}));
    run(world, 0.2);
    const WorldSummary before = world.summary();
    ASSERT_EQ(before.shapes, 4);
    ASSERT_EQ(before.contacts, 2);
    must(world.destroy_body(body));
    EXPECT_FALSE(world.contains(body));
    EXPECT_FALSE(world.contains(joint));
    EXPECT_TRUE(world.contains(floor));
    const WorldSummary after = world.summary();
    EXPECT_EQ(after.bodies, 2);
    EXPECT_EQ(after.shapes, 2);
    EXPECT_EQ(after.contacts, 1);
    EXPECT_EQ(after.joints, 0);
    EXPECT_EQ(world.islands().size(), 1u);
    EXPECT_EQ(find_fault(state_of(world)), std::nullopt);
}

}  // namespace
}  // namespace jostle::test
