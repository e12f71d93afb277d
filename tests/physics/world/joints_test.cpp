// SPDX-License-Identifier: MIT
//
// Joints are created, read, changed and destroyed. What they do: behaviour/joints_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "jostle/physics/restore_point.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

struct Pair {
    World world = make_world({.gravity = {}});
    BodyId a = add(world, {}), b = add(world, {.position = {3, 0, 0}});

    JointDef def(const JointKind& kind = BallJoint{}) const {
        return {.body_a = a,
                .body_b = b,
                .frame_a = {.position = {1.5, 0, 0}},
                .frame_b = {.position = {-1.5, 0, 0}},
                .kind = kind};
    }
    std::string error_of(const JointDef& joint) {
        const auto made = world.create_joint(joint);
        return made.ok() ? "" : made.error().message;
    }
};

TEST(JointCalls, round_trips_a_joint) {
    Pair pair;
    JointDef def = pair.def(DistanceJoint{.min_length = 0, .max_length = 2});
    def.frame_b.position = {-1, 0, 0};
    def.break_force = 50;
    def.user_data = 9;
    const JointId joint = must(pair.world.create_joint(def));
    const JointState state = must(pair.world.joint(joint));
    EXPECT_EQ(state.id, joint);
    EXPECT_EQ(state.def.body_b, pair.b);
    EXPECT_EQ(state.def.break_force, 50);
    EXPECT_EQ(state.def.user_data, 9u);
    EXPECT_EQ(state.def.kind, def.kind);
    EXPECT_NEAR(state.separation, 0.5, 1e-12);
}

// What it asks of the solver is kept as it is said, and what is no solver is refused.
TEST(JointCalls, reports_the_joint_solver) {
    Pair pair;
    JointDef def = pair.def();
    const JointId silent = must(pair.world.create_joint(def));
    EXPECT_EQ(must(pair.world.joint(silent)).def.solver, std::nullopt);
    def.solver = JointSolver::iterative;
    const JointId joint = must(pair.world.create_joint(def));
    EXPECT_EQ(must(pair.world.joint(joint)).def.solver, JointSolver::iterative);
    must(pair.world.set_joint_solver(joint, JointSolver::direct));
    EXPECT_EQ(must(pair.world.joint(joint)).def.solver, JointSolver::direct);
    const Status wrong = pair.world.set_joint_solver(joint, static_cast<JointSolver>(7));
    ASSERT_FALSE(wrong.ok());
    EXPECT_EQ(wrong.error().message,
              "solver is 7; it must be automatic (0), iterative (1) or direct (2)");
    EXPECT_EQ(must(pair.world.joint(joint)).def.solver, JointSolver::direct);
    must(pair.world.set_joint_solver(joint, {}));
    EXPECT_EQ(must(pair.world.joint(joint)).def.solver, std::nullopt);
    def.solver = static_cast<JointSolver>(9);
    EXPECT_THAT(pair.error_of(def), HasSubstr("solver is 9"));
    EXPECT_FALSE(pair.world.set_joint_solver(static_cast<JointSolver>(3)).ok());
    EXPECT_EQ(pair.world.joint_solver(), JointSolver::automatic);
    must(pair.world.destroy_joint(joint));
    EXPECT_FALSE(pair.world.set_joint_solver(joint, JointSolver::direct).ok());
}

TEST(JointCalls, angles_match_the_frames) {
    Pair pair;
    JointDef hinge = pair.def(HingeJoint{});
    hinge.frame_b.rotation = from_axis_angle({0, 0, 1}, 0.3);
    EXPECT_NEAR(must(pair.world.joint(must(pair.world.create_joint(hinge)))).angle, 0.3, 1e-12);
    JointDef cone = pair.def(ConeTwistJoint{});
    cone.frame_b.rotation = from_axis_angle({0, 1, 0}, 0.2) * from_axis_angle({1, 0, 0}, -0.4);
    const JointState state = must(pair.world.joint(must(pair.world.create_joint(cone))));
    EXPECT_NEAR(state.swing, 0.2, 1e-12);
    EXPECT_NEAR(state.angle, -0.4, 1e-12);
}

TEST(JointCalls, errors_name_the_problem) {
    Pair pair;
    JointDef self = pair.def();
    self.body_b = pair.a;
    EXPECT_THAT(pair.error_of(self), HasSubstr("the same body"));
    JointDef walls = pair.def();
    walls.body_a = add_static(pair.world, {.position = {0, 9, 0}});
    walls.body_b = add_static(pair.world, {.position = {9, 9, 0}});
    EXPECT_THAT(pair.error_of(walls), HasSubstr("dynamic"));
    EXPECT_THAT(pair.error_of(pair.def(HingeJoint{.limit = {true, 1, -1}})),
                HasSubstr("hinge.limit.lower is above"));
    EXPECT_THAT(pair.error_of(pair.def(ConeTwistJoint{.swing = 4})),
                HasSubstr("cone_twist.swing is 4"));
    EXPECT_THAT(pair.error_of(pair.def(DistanceJoint{.min_length = 2, .max_length = 1})),
                HasSubstr("distance.max_length is 1; it must be from 2"));
    EXPECT_THAT(pair.error_of(pair.def(FixedJoint{.linear = {.hertz = -1}})),
                HasSubstr("fixed.linear.hertz is -1"));
    JointDef broken = pair.def();
    broken.break_force = std::nan("");
    EXPECT_THAT(pair.error_of(broken), HasSubstr("break_force"));
    EXPECT_TRUE(pair.world.joints().empty());
}

TEST(JointCalls, are_listed_in_order_and_per_body) {
    Pair pair;
    const BodyId c = add(pair.world, {.position = {6, 0, 0}});
    const JointId first = must(pair.world.create_joint(pair.def()));
    JointDef second_def = pair.def();
    second_def.body_a = pair.b;
    second_def.body_b = c;
    const JointId second = must(pair.world.create_joint(second_def));
    EXPECT_EQ(pair.world.joints(), (std::vector{first, second}));
    EXPECT_EQ(pair.world.joints_of(pair.b), (std::vector{first, second}));
    EXPECT_EQ(pair.world.joints_of(c), std::vector{second});
    must(pair.world.destroy_joint(first));
    EXPECT_FALSE(pair.world.contains(first));
    EXPECT_EQ(pair.world.joints(), std::vector{second});
    EXPECT_FALSE(pair.world.destroy_joint(first).ok());
}

TEST(JointRevision, changes_when_a_joint_is_created_destroyed_or_breaks) {
    Pair pair;
    std::uint64_t last = pair.world.joint_revision();
    const auto changed = [&] {
        const std::uint64_t before = std::exchange(last, pair.world.joint_revision());
        return last != before;
    };
    const JointId joint = must(pair.world.create_joint(pair.def()));
    EXPECT_TRUE(changed());
    must(pair.world.set_joint(joint, BallJoint{.friction_torque = 1}));
    run(pair.world, 0.1);
    EXPECT_FALSE(changed());
    must(pair.world.destroy_joint(joint));
    EXPECT_TRUE(changed());
    JointDef weak = pair.def();
    weak.break_force = 1;
    must(pair.world.create_joint(weak));
    RestorePoint point;
    point.capture(pair.world);
    static_cast<void>(changed());
    must(pair.world.apply_impulse(pair.b, {1e5, 0, 0}, {3, 0, 0}));
    run(pair.world, 0.1);
    EXPECT_TRUE(pair.world.joints().empty());
    EXPECT_TRUE(changed());
    must(point.restore(pair.world));
    EXPECT_TRUE(changed());
    must(pair.world.destroy_body(pair.a));
    EXPECT_TRUE(changed());
}

TEST(JointCalls, allows_changing_values_but_not_the_kind) {
    Pair pair;
    const JointId joint = must(pair.world.create_joint(pair.def(HingeJoint{})));
    const JointKind faster = HingeJoint{.motor = {true, 2, 5}};
    must(pair.world.set_joint(joint, faster));
    EXPECT_EQ(must(pair.world.joint(joint)).def.kind, faster);
    EXPECT_THAT(pair.world.set_joint(joint, BallJoint{}).error().message,
                HasSubstr("the joint is a hinge; it cannot become a ball"));
    EXPECT_EQ(must(pair.world.joint(joint)).def.kind, faster);
}

}  // namespace
}  // namespace jostle::test
