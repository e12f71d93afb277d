// SPDX-License-Identifier: MIT
#include "server/world/joint_list.h"

#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::server {
namespace {

using namespace physics;
using test::add;
using test::make_world;
using test::must;

class JointListTest : public testing::Test {
protected:
    JointId connect(BodyId a, BodyId b, const JointKind& kind = BallJoint{},
                    double break_force = 0) {
        return must(world.create_joint({.body_a = a,
                                        .body_b = b,
                                        .frame_a = {.position = {0.5, 0, 0}},
                                        .frame_b = {.position = {-0.5, 0, 0}},
                                        .kind = kind,
                                        .break_force = break_force}));
    }
    std::shared_ptr<const JointList> list() {
        return registry.list(world, [](BodyId body) { return EntityId{body.index + 10}; });
    }

    World world = make_world({.gravity = {}});
    BodyId a = add(world, {}), b = add(world, {.position = {1, 0, 0}}),
           c = add(world, {.position = {2, 0, 0}});
    JointRegistry registry;
};

TEST_F(JointListTest, lists_joints_between_entities_and_to_the_world) {
    connect(a, b);
    connect({}, c);
    const auto joints = list();
    ASSERT_EQ(joints->size(), 2u);
    EXPECT_EQ((*joints)[0]->entity_a, EntityId{a.index + 10});
    EXPECT_EQ((*joints)[1]->entity_a, 0u);
    EXPECT_EQ((*joints)[1]->entity_b, EntityId{c.index + 10});
}

TEST_F(JointListTest, is_the_same_object_until_a_joint_appears_or_disappears) {
    const JointId joint = connect(a, b);
    const auto first = list();
    test::run(world, 0.1);
    EXPECT_EQ(list(), first);
    // A grab of a client comes and goes.
    const JointId grab = connect({}, c, GrabJoint{});
    EXPECT_EQ(list(), first);
    must(world.destroy_joint(grab));
    EXPECT_EQ(list(), first);
    connect(b, c);
    const auto second = list();
    EXPECT_NE(second, first);
    EXPECT_EQ(second->front(), first->front()) << "descriptions are shared";
    must(world.destroy_joint(joint));
    ASSERT_EQ(list()->size(), 1u);
    EXPECT_EQ(list()->front(), second->back());
}

TEST_F(JointListTest, ids_are_not_reused) {
    must(world.destroy_joint(connect(a, b)));
    const JointId first = connect(a, b);
    const std::uint32_t id = list()->front()->id;
    must(world.destroy_joint(first));
    connect(a, b);
    EXPECT_GT(list()->front()->id, id);
}

TEST_F(JointListTest, joints_end_with_their_body_or_when_they_break) {
    connect(a, b);
    connect(b, c, BallJoint{}, 1);
    EXPECT_EQ(list()->size(), 2u);
    must(world.apply_impulse(c, {1e5, 0, 0}, {2, 0, 0}));
    test::run(world, 0.1);
    EXPECT_EQ(list()->size(), 1u) << "the second joint breaks at 1 N";
    must(world.destroy_body(a));
    EXPECT_TRUE(list()->empty());
}

}  // namespace
}  // namespace jostle::server
