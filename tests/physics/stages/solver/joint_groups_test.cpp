// SPDX-License-Identifier: MIT
//
// Which joints are solved directly, and that a world keeps what they carry.
#include "physics/src/stages/solver/joint_groups.h"

#include <gtest/gtest.h>

#include "tests/support/ball_net.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

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
TEST(JointGroups, contain_jointed_bodies_without_contacts) {
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

// 20 x 20 balls, each tied to its neighbours to the left and above, cost too much to be solved
// directly. Cut into columns they are chains, which do not.
TEST(JointGroups, exclude_cloth_until_it_is_cut) {
    World world = make_world();
    constexpr int n = 20;
    const BallNet net = add_ball_net(world, n, {}, {0, -1, 0}, {1, 0, 0});
    EXPECT_EQ(direct(world), 0);
    EXPECT_EQ(direct(world), 0);
    for (const JointId joint : net.across) must(world.destroy_joint(joint));
    run(world, 0.5);  // islands are cut one after the other
    EXPECT_EQ(world.profile().joints_direct, n * (n - 1));
}

// Saved in full swing and loaded, it swings on to the same bits: a hinge with a motor and a limit,
// a chain, a body whose axes are not those of its inertia.
TEST(JointGroups, continue_bit_identically_after_load) {
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
TEST(JointGroups, follow_a_kinematic_pivot_and_report_forces) {
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
TEST(JointGroups, break_above_their_force) {
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

// A cart on rails, by locks, with a pendulum: no force along the rails but between the two.
TEST(JointGroups, support_bodies_with_locked_axes) {
    World world = make_world();
    const BodyId cart = must(world.create_body(
        {.pose = {.position = {0, 10, 0}},
         .locks = lock_y | lock_z | lock_rotation_x | lock_rotation_y | lock_rotation_z},
        {.geometry = Box{{0.2, 0.1, 0.1}}}));
    const BodyId bob =
        add(world, {.geometry = Sphere{0.1}, .position = {1, 10, 0}, .sleep_allowed = false});
    must(world.create_joint({.body_a = cart, .body_b = bob, .frame_b = {.position = {-1, 0, 0}}}));
    const double m = must(world.body(cart)).mass, n = must(world.body(bob)).mass;
    const auto energy = [&] {
        const BodyState a = state_of(world, cart), b = state_of(world, bob);
        const double inertia = 0.4 * n * 0.01;
        return 0.5 * (m * dot(a.linear_velocity, a.linear_velocity) +
                      n * dot(b.linear_velocity, b.linear_velocity) +
                      inertia * dot(b.angular_velocity, b.angular_velocity)) +
               n * 9.81 * b.center.y;
    };
    const double before = energy();
    for (int k = 0; k < 300; k++) {
        must(world.step(1.0 / 60));
        ASSERT_EQ(world.profile().joints_direct, 1);
        const BodyState a = state_of(world, cart), b = state_of(world, bob);
        EXPECT_NEAR(m * a.center.x + n * b.center.x, n, 1e-9 * n);
        EXPECT_EQ(a.center.y, 10);
        EXPECT_EQ(a.angular_velocity, Vec3{});
        EXPECT_NEAR(length(b.center - a.center), 1, 1e-6);
        EXPECT_NEAR(energy(), before, 3e-5 * n * 9.81);
    }
}

// In the plane, too, a whip with a heavy end holds together and gains nothing.
TEST(JointGroups, support_planar_worlds) {
    World world = make_world({.planar = true});
    BodyId last{};
    std::vector<JointId> joints;
    for (int k = 0; k < 8; k++) {
        const BodyId link = must(world.create_body(
            {.pose = {.position = {0.2 + 0.4 * k, 20, 0}}, .sleep_allowed = false},
            {.geometry = Box{{0.2, 0.02, 0.5}},
             .density = k == 7 ? 1e6 : 1e3,
             .filter = {.category = 0, .mask = 0}}));
        JointDef def{.body_b = link,
                     .frame_a = {.position = {0, 20, 0}},
                     .frame_b = {.position = {-0.2, 0, 0}},
                     .kind = HingeJoint{}};
        if (k > 0) {
            def.body_a = last;
            def.frame_a = {.position = {0.2, 0, 0}};
        }
        joints.push_back(must(world.create_joint(def)));
        last = link;
    }
    const double weight = must(world.body(last)).mass * 9.81;
    for (int k = 0; k < 180; k++) {
        must(world.step(1.0 / 60));
        ASSERT_EQ(world.profile().joints_direct, 8);
        for (const JointId joint : joints) {
            EXPECT_LT(must(world.joint(joint)).separation, 1e-5);
        }
        const BodyState end = state_of(world, last);
        EXPECT_LT(0.5 * end.mass * dot(end.linear_velocity, end.linear_velocity) +
                      weight * (end.center.y - 20),
                  0.01 * weight);
        EXPECT_EQ(end.center.z, 0);
    }
}

// Rows of joints along locked axes are left out, whatever their rounding: a six-dof whose frames
// are turned from axis to axis, ends that are apart out of the plane, a motor about a locked axis.
TEST(JointGroups, skip_rows_that_locked_axes_satisfy) {
    World world = make_world({.gravity = {0, -9.81, 0}, .planar = true});
    BodyId last{};
    SixDofJoint turns;
    turns.axes->rotation_y.free = turns.axes->rotation_z.free = true;
    turns.axes->rotation_y.motor = {true, 3, 10};
    turns.axes->rotation_z.limit = {true, -0.5, 0.5};
    const JointKind kinds[] = {HingeJoint{}, turns, turns, BallJoint{}, turns};
    double mass = 0;
    int k = 0;
    for (const JointKind& kind : kinds) {
        const BodyId link = must(world.create_body(
            {.pose = {.position = {0.2 + 0.4 * k, 20, 0}}, .sleep_allowed = false},
            {.geometry = Box{{0.2, 0.02, 0.5}}, .filter = {.category = 0, .mask = 0}}));
        JointDef def{.body_b = link,
                     .frame_a = {.position = {0, 20, 0}},
                     .frame_b = {.position = {-0.2, 0, 0.1 * k}},
                     .kind = kind};
        if (k > 0) {
            def.body_a = last;
            def.frame_a = {.position = {0.2, 0, 0}};
        }
        must(world.create_joint(def));
        mass = must(world.body(link)).mass;
        last = link;
        k++;
    }
    for (int step = 0; step < 300; step++) {
        must(world.step(1.0 / 60));
        ASSERT_EQ(world.profile().joints_direct, 5);
        double energy = 0;  // of five links, as high as at the start
        for (const BodyId id : world.bodies()) {
            const BodyState body = state_of(world, id);
            energy += 0.5 * mass * dot(body.linear_velocity, body.linear_velocity) +
                      mass * 9.81 * (body.center.y - 20);
            EXPECT_LT(length(body.center - Vec3{0, 20, 0}), 2.1);
        }
        EXPECT_LT(energy, 0.01 * mass * 9.81) << step;
    }
}

}  // namespace
}  // namespace jostle::test
