// SPDX-License-Identifier: MIT
//
// Figures stand, fall, follow poses and are released.
#include "jostle/modules/ragdoll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/modules/ragdoll/figures.h"

namespace jostle::modules {
namespace {

using namespace physics;

double highest(const Stage& stage, RagdollId id) {
    double y = -1e9;
    for (const BodyId body : *stage.ragdolls->bodies(id))
        y = std::max(y, stage.world.body(body)->pose.position.y);
    return y;
}

TEST(Ragdoll, limp_figure_falls_and_sleeps) {
    Stage stage;
    stage.floor();
    const RagdollId id = stage.add(human_figure());
    EXPECT_NEAR(highest(stage, id), 1.66, 1e-9) << "its head";
    for (int k = 0; k < 1200; k++) stage.step();
    EXPECT_LT(highest(stage, id), 0.5);
    EXPECT_EQ(stage.world.summary().awake_bodies, 0);
}

// A kinematic figure follows the pose within 1 um and pushes bodies in its way.
TEST(Ragdoll, kinematic_figure_follows_the_pose_and_pushes) {
    Stage stage({.gravity = {}});
    const BodyId ball = *stage.world.create_body({.pose = {.position = {0.7, 1.42, 0.4}}},
                                                 {.geometry = Sphere{0.1}});
    const RagdollId id = stage.add(human_figure(1.8));
    stage.ragdolls->set_mode(stage.world, id, RagdollMode::kinematic).expect();
    RagdollPose pose = *stage.ragdolls->pose(stage.world, id);
    for (int k = 1; k <= 60; k++) {
        pose.root.position = {0, 0, k / 60.0};
        stage.ragdolls->set_pose(id, pose).expect();
        stage.step();
        const Vec3 pelvis = stage.world.body(stage.ragdolls->bodies(id)->front())->pose.position;
        ASSERT_NEAR(pelvis.z, k / 60.0, 1e-6);
    }
    EXPECT_GT(stage.world.body(ball)->linear_velocity.z, 0.5) << "hit by an arm at 1 m/s";
}

// When kinematic mode ends, it continues with its velocity, and its joints hold it together.
TEST(Ragdoll, figure_keeps_its_velocity_when_kinematic_mode_ends) {
    Stage stage({.gravity = {}});
    const RagdollId id = stage.add(human_figure());
    stage.ragdolls->set_mode(stage.world, id, RagdollMode::kinematic).expect();
    RagdollPose pose = *stage.ragdolls->pose(stage.world, id);
    for (int k = 1; k <= 30; k++) {
        pose.root.position = {0, 0, 3 * k / 60.0};
        stage.ragdolls->set_pose(id, pose).expect();
        stage.step();
    }
    stage.ragdolls->set_mode(stage.world, id, RagdollMode::limp).expect();
    for (int k = 0; k < 60; k++) stage.step();
    for (const BodyId body : *stage.ragdolls->bodies(id))
        EXPECT_NEAR(stage.world.body(body)->linear_velocity.z, 3, 1e-5);
    EXPECT_LT(stage.world.summary().max_joint_error, 1e-4);
    EXPECT_EQ(stage.world.summary().joints, 10);
}

// From the floor back to its feet within 1 s: no bone moves faster than the blend requires.
TEST(Ragdoll, blend_moves_a_fallen_figure_back_gradually) {
    Stage stage;
    stage.floor();
    const RagdollId id = stage.add(human_figure());
    for (int k = 0; k < 180; k++) stage.step();
    stage.ragdolls->set_mode(stage.world, id, RagdollMode::kinematic, 1).expect();
    double fastest = 0;
    for (int k = 0; k < 61; k++) {
        stage.step();
        for (const BodyId body : *stage.ragdolls->bodies(id))
            fastest = std::max(fastest, length(stage.world.body(body)->linear_velocity));
    }
    EXPECT_NEAR(highest(stage, id), 1.66, 1e-6);
    EXPECT_LT(fastest, 6);
}

// With its neck joint destroyed, the rest of the figure falls, and other figures are unaffected.
TEST(Ragdoll, figure_with_a_lost_joint_is_released_and_others_are_unaffected) {
    Stage stage;
    stage.floor();
    const RagdollId one = stage.add(human_figure()),
                    two = stage.add(human_figure(), {{3, 0, 0}, {}});
    stage.world.destroy_joint((*stage.ragdolls->joints(one))[2]).expect();
    stage.step();
    EXPECT_FALSE(stage.ragdolls->contains(one));
    EXPECT_TRUE(stage.ragdolls->contains(two));
    EXPECT_EQ(stage.ragdolls->size(), 1u);
    const RagdollId next = stage.add(human_figure(), {{6, 0, 0}, {}});
    EXPECT_EQ(next.index, one.index);
    EXPECT_FALSE(stage.ragdolls->contains(one)) << "another figure uses the index";
    stage.ragdolls->remove(stage.world, two).expect();
    EXPECT_EQ(stage.ragdolls->size(), 1u);
}

// The hand of one figure is quarantined, and the head of another is destroyed: both are released
// with limp muscles, and the third stands unaffected.
TEST(Ragdoll, removes_figures_individually) {
    double height[2] = {};
    for (const bool lost : {false, true}) {
        Stage stage;
        stage.floor();
        RagdollId ids[3];
        for (int k = 0; k < 3; k++) {
            ids[k] = stage.add(human_figure(), {{5.0 * k, 0, 0}, {}});
            stage.ragdolls->set_mode(stage.world, ids[k], RagdollMode::powered).expect();
        }
        for (int k = 0; k < 10; k++) stage.step();
        const std::vector<JointId> joints = *stage.ragdolls->joints(ids[0]);
        if (lost) {
            const BodyId hand = (*stage.ragdolls->bodies(ids[0]))[5];
            const Vec3 hand_position = stage.world.body(hand)->pose.position;
            stage.world.apply_impulse(hand, {0, 1e9, 0}, hand_position).expect();
            stage.world.destroy_body((*stage.ragdolls->bodies(ids[1]))[2]).expect();
        }
        for (int k = 0; k < 20; k++) stage.step();
        for (int k = 0; k < 2; k++) EXPECT_EQ(stage.ragdolls->contains(ids[k]), !lost) << k;
        ASSERT_TRUE(stage.ragdolls->contains(ids[2]));
        height[lost ? 1 : 0] = highest(stage, ids[2]);
        if (!lost) continue;
        const auto neck = std::get<ConeTwistJoint>(stage.world.joint(joints[1])->def.kind);
        EXPECT_EQ(neck.drive.spring.hertz, 0) << "its muscles are limp";
    }
    EXPECT_EQ(height[0], height[1]);
}

TEST(Ragdoll, errors_name_the_bone_and_leave_no_bodies) {
    Stage stage;
    const auto error_of = [&](auto change) {
        RagdollDef def = human_figure();
        change(def);
        const Result<RagdollId> id = stage.ragdolls->add(stage.world, def, {});
        EXPECT_EQ(stage.world.summary().bodies, 0);
        return id.ok() ? std::string() : id.error().message;
    };
    EXPECT_EQ(error_of([](RagdollDef& d) { d.bones[3].parent = 7; }),
              "bones[3] (left upper arm): parent is 7; it must be the index of an earlier bone");
    EXPECT_EQ(error_of([](RagdollDef& d) { d.bones[2].shapes.clear(); }),
              "bones[2] (head) has no shape; it must have at least one");
    EXPECT_EQ(error_of([](RagdollDef& d) { d.bones[2].muscle.hertz = -1; }),
              "bones[2] (head): muscle.hertz must be from 0 to 1000");
    EXPECT_EQ(error_of([](RagdollDef& d) { d.bones[5].joint = SliderJoint{}; }),
              "bones[5] (left lower arm): joint is a slider; it must be a ball, a hinge or a "
              "cone-twist");
    EXPECT_NE(error_of([](RagdollDef& d) {
                  d.bones[1].joint = ConeTwistJoint{.swing = 9};
              }).find("bones[1].joint"),
              std::string::npos);
    EXPECT_NE(error_of([](RagdollDef& d) { d.bones.clear(); }), "");
    const RagdollId id = stage.add(human_figure());
    EXPECT_FALSE(stage.ragdolls->set_pose(id, {}).ok()) << "no rotations";
    EXPECT_FALSE(stage.ragdolls->set_strength(id, 11, 1).ok());
    EXPECT_FALSE(stage.ragdolls->set_strength(id, 1, std::nan("")).ok());
    EXPECT_FALSE(stage.ragdolls->set_mode(stage.world, id, RagdollMode::limp, -1).ok());
    EXPECT_FALSE(stage.ragdolls->set_mode(stage.world, {5, 1}, RagdollMode::limp).ok());
}

}  // namespace
}  // namespace jostle::modules
