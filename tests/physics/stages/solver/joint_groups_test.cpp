// SPDX-License-Identifier: MIT
//
// Which joints are solved directly, and that a world keeps what they carry.
#include "stages/solver/joint_groups.h"

#include <gtest/gtest.h>

#include "support/near.h"
#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

JointId hang(World& world, BodyId body, Vec3 pivot, const JointKind& kind = BallJoint{}) {
    return must(world.create_joint({.body_b = body,
                                    .frame_a = {.position = pivot},
                                    .frame_b = {.position = pivot - position_of(world, body)},
                                    .kind = kind}));
}

int direct(World& world) {
    must(world.step(1.0 / 60));
    return world.profile().joints_direct;
}

// A pendulum is a group, and so is what hangs on a spring; what a muscle turns or what lies on the
// floor is not.
TEST(JointGroups, are_what_hangs_together_and_touches_nothing) {
    World world = make_world();
    const BodyId bob = add(world, {.geometry = Sphere{0.2}, .position = {1, 3, 0}});
    hang(world, bob, {0, 3, 0});
    EXPECT_EQ(direct(world), 1);
    const BodyId other = add(world, {.geometry = Sphere{0.2}, .position = {5, 3, 0}});
    const JointId spring =
        hang(world, other, {5, 4, 0},
             DistanceJoint{.min_length = 0, .max_length = 3, .spring = {1, 0.1}, .rest_length = 1});
    EXPECT_EQ(direct(world), 2);
    must(world.destroy_joint(spring));
    hang(world, other, position_of(world, other), BallJoint{.drive = {.spring = {1, 1}}});
    EXPECT_EQ(direct(world), 1) << "the muscle is another's";
    add_floor(world);
    must(world.set_pose(bob, {.position = {0, 0.2, 0}}));
    EXPECT_EQ(direct(world), 0) << "it lies on the floor";
}

// Saved in full swing and loaded, it swings on to the same bits: a hinge with a motor and a limit,
// a chain, a body whose axes are not those of its inertia.
TEST(JointGroups, go_on_to_the_same_bits_after_a_load) {
    World world = make_world();
    const BodyId arm = add(world, {.geometry = Box{{0.5, 0.1, 0.2}},
                                   .position = {0.5, 5, 0},
                                   .rotation = from_axis_angle({0, 0, 1}, 0)});
    hang(world, arm, {0, 5, 0},
         HingeJoint{.limit = {true, -1, 1},
                    .motor = {.enabled = true, .speed = 3, .max_torque = 900}});
    BodyId last{};
    for (int k = 0; k < 6; k++) {
        const BodyId link =
            add(world, {.geometry = Capsule{0.05, 0.1}, .position = {4 + 0.4 * k, 5, 0}});
        if (k == 0)
            hang(world, link, {3.8, 5, 0});
        else
            must(world.create_joint({.body_a = last,
                                     .body_b = link,
                                     .frame_a = {.position = {0.2, 0, 0}},
                                     .frame_b = {.position = {-0.2, 0, 0}}}));
        last = link;
    }
    must(world.create_shape(
        last, {.geometry = Box{{0.2, 0.1, 0.1}}, .pose = {.position = {0.2, 0.1, 0.1}}}));
    run(world, 0.5);
    EXPECT_EQ(world.profile().joints_direct, 7);
    World loaded = must(load(save(world)));
    run(world, 2);
    run(loaded, 2);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
}

// A pivot that is moved takes its pendulum along; the joint reports the weight.
TEST(JointGroups, follow_a_kinematic_pivot_and_report_what_they_bear) {
    World world = make_world();
    const BodyId pivot = add(world, {.geometry = Sphere{0.1}, .type = BodyType::kinematic});
    const BodyId bob =
        add(world, {.geometry = Sphere{0.2}, .position = {0, -1, 0}, .sleep_allowed = false});
    const JointId joint = must(
        world.create_joint({.body_a = pivot, .body_b = bob, .frame_b = {.position = {0, 1, 0}}}));
    run(world, 1);
    const double weight = must(world.body(bob)).mass * 9.81;
    EXPECT_NEAR(must(world.joint(joint)).force.y, weight, 1e-3 * weight);
    must(world.set_linear_velocity(pivot, {0, 2, 0}));
    must(world.set_linear_velocity(bob, {0, 2, 0}));
    run(world, 1);
    EXPECT_NEAR(position_of(world, bob).y, 1, 1e-4);
    EXPECT_LT(must(world.joint(joint)).separation, 1e-6);
}

// What bears less than the weight breaks in the first step, with the force it bore.
TEST(JointGroups, break) {
    World world = make_world();
    const BodyId bob = add(world, {.geometry = Sphere{0.2}, .position = {0, -1, 0}});
    const double weight = must(world.body(bob)).mass * 9.81;
    must(world.create_joint(
        {.body_b = bob, .frame_b = {.position = {0, 1, 0}}, .break_force = 0.9 * weight}));
    must(world.step(1.0 / 60));
    ASSERT_EQ(world.events().joints_broke.size(), 1u);
    EXPECT_NEAR(world.events().joints_broke[0].force, weight, 0.01 * weight);
    EXPECT_TRUE(world.joints().empty());
}

}  // namespace
}  // namespace jostle::test
