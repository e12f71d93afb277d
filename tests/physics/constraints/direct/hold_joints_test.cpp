// SPDX-License-Identifier: MIT
//
// Bodies that a contact solver accelerates end a sub-step with closed joints, within their limits.
#include <gtest/gtest.h>

#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {

constexpr DirectGroup::HoldTolerance hold_tolerance{1e-3, 0.01, 1e-6};
constexpr double substep = 1.0 / 480;

// Two rods of 1 m along x, joined at the origin by a hinge about y of at most 0.05 rad either way.
DirectGroup jointed_rods() {
    DirectGroup group;
    for (const double side : {-0.5, 0.5})
        group.bodies.push_back(body_at({side, 0, 0}, side > 0 ? 1 : 3, {0.01, 0.1, 0.1}));
    join(group, 0, 1, HingeJoint{.limit = {true, -0.05, 0.05}}, {0.5, 0, 0}, {-0.5, 0, 0}, about_y);
    for (DirectBody& body : group.bodies) {
        body.turned_from = body.q;
        body.turned = {};
    }
    EXPECT_TRUE(group.prepare());
    return group;
}

void turn(DirectBody& body, double spin) {
    body.l = Vec3{0, spin / body.inverse_inertia.y.y, 0};
}

double angle_after(DirectGroup& group) {
    return trial_value(group.joints[0], group.joints[0].free_axes[0], group.bodies);
}

TEST(HoldJoints, changes_nothing_within_tolerance) {
    DirectGroup group = jointed_rods();
    turn(group.bodies[1], 3);
    group.bodies[1].p = {0, 0, -1.5};  // about the joint
    const Vec3 l = group.bodies[1].l;
    EXPECT_FALSE(group.hold_joints(substep, hold_tolerance));
    EXPECT_EQ(group.bodies[1].l, l);
}

// 60 rad/s: 0.125 rad within the sub-step.
TEST(HoldJoints, stops_at_the_limit_and_conserves_momentum) {
    for (const double spin : {60.0, -60.0}) {
        DirectGroup group = jointed_rods();
        turn(group.bodies[1], spin);
        const Vec3 p = group.bodies[0].p + group.bodies[1].p;
        const auto angular = [&] {
            Vec3 sum;
            for (const DirectBody& body : group.bodies) sum += body.l + cross(body.x, body.p);
            return sum;
        };
        const Vec3 l = angular();
        EXPECT_TRUE(group.hold_joints(substep, hold_tolerance));
        EXPECT_NEAR(absolute(angle_after(group)), 0.05, 1e-4);
        EXPECT_LT(length(group.bodies[0].p + group.bodies[1].p - p), 1e-9);
        EXPECT_LT(length(angular() - l), 1e-9);
        for (const DirectBody& body : group.bodies) EXPECT_LT(length(body.x1 - body.x), 0.1);
    }
}

// An end that is apart by 1 cm is closed, within the bounds of the correction speed.
TEST(HoldJoints, closes_a_gap) {
    DirectGroup group = jointed_rods();
    group.bodies[1].x.z += 0.01;
    EXPECT_NEAR(group.joint_error(), 0.01, 1e-12);
    EXPECT_TRUE(group.hold_joints(substep, hold_tolerance));
    const DirectBody &a = group.bodies[0], &b = group.bodies[1];
    EXPECT_LT(length((b.x1 + b.axes1 * Vec3{-0.5, 0, 0}) - (a.x1 + a.axes1 * Vec3{0.5, 0, 0})),
              1e-5);
}

}  // namespace
}  // namespace jostle::test
