// SPDX-License-Identifier: MIT
#include "server/world/joint_list.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

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

TEST_F(JointListTest, ids_are_known_before_a_joint_is_listed) {
    connect(a, b);
    const JointId other = connect(b, c), created = connect(a, c);
    EXPECT_EQ(registry.id_of(created), 1u);
    ASSERT_EQ(list()->size(), 3u);
    EXPECT_EQ(list()->front()->joint, created);
    EXPECT_EQ(registry.find(registry.id_of(other)), other);
    EXPECT_TRUE(is_null(registry.find(99)));
    must(world.destroy_joint(created));
    const JointId reused = connect(a, c);
    EXPECT_EQ(reused.index, created.index);
    EXPECT_EQ(registry.id_of(reused), 4u);
    ASSERT_EQ(list()->size(), 3u);
    EXPECT_EQ(list()->back()->joint, reused);
}

// Describing all joints of a large world in one tick would delay it.
TEST_F(JointListTest, describes_4096_joints_per_call) {
    std::vector<JointId> joints;
    for (int k = 0; k < 10000; k++) joints.push_back(connect(a, b));
    std::vector<std::size_t> sizes;
    for (int k = 0; k < 4; k++) sizes.push_back(list()->size());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{4096, 8192, 10000, 10000}));
    const auto complete = list();
    EXPECT_EQ(list(), complete);
    // Removals are not limited.
    for (std::size_t k = 0; k < joints.size(); k += 2) must(world.destroy_joint(joints[k]));
    EXPECT_EQ(list()->size(), 5000u);
    EXPECT_EQ(list()->front(), (*complete)[1]);
}

}  // namespace
}  // namespace jostle::server
