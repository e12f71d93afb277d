// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {

constexpr double h = 1.0 / 480;

// Two bodies askew, with a joint that fits them as they are.
DirectGroup askew(const JointKind& kind) {
    DirectGroup group;
    group.bodies = {body_at({}, 2, {0.02, 0.03, 0.04}),
                    body_at({0.5, 0.1, 0}, 1, {0.01, 0.02, 0.02})};
    for (DirectBody& body : group.bodies) {
        body.q = normalized(Quat{0.2, -0.4, 0.1, 0.8});
        refresh(body);
    }
    const Vec3 from_a = inverse_rotate(group.bodies[0].q, group.bodies[1].x);
    join(group, 0, 1, kind, from_a, {}, normalized(Quat{0.1, 0.3, -0.2, 0.7}));
    return group;
}

JointKind with_axes(bool rotation_x, bool rotation_z, bool slides) {
    SixDofJoint six;
    six.axes->x.free = slides;
    six.axes->x.limit = {slides, -1, 1};
    six.axes->rotation_x.free = rotation_x;
    six.axes->rotation_z.free = rotation_z;
    return six;
}

// What rows carry comes back as it was kept, for every mix of rows.
TEST(DirectWarmStart, round_trips_row_impulses) {
    const JointKind kinds[] = {BallJoint{},
                               HingeJoint{},
                               FixedJoint{},
                               DistanceJoint{.min_length = 1, .max_length = 1},
                               SliderJoint{},
                               WheelJoint{.steering = 0},
                               with_axes(false, false, false),
                               with_axes(true, false, false),
                               with_axes(false, true, true),
                               with_axes(true, true, true)};
    for (const JointKind& kind : kinds) {
        DirectGroup group = askew(kind);
        DirectJoint& joint = group.joints[0];
        for (int k = 0; k < joint.first_free_axis(); k++) joint.force[k] = 3 + k;
        const WarmStartCache kept = save_forces(joint, group.bodies[0], group.bodies[1], h);
        for (double& force : joint.force) force = 0;
        load_forces(joint, group.bodies[0], group.bodies[1], kept, h);
        for (int k = 0; k < joint.first_free_axis(); k++)
            EXPECT_NEAR(joint.force[k], 3 + k, 1e-9) << kind_name(kind) << " row " << k;
    }
}

TEST(DirectWarmStart, round_trips_limit_and_motor_impulses) {
    DirectGroup group =
        askew(SliderJoint{.limit = {true, 0, 2}, .motor = {true, 1, 10}, .friction_force = 4});
    DirectJoint& joint = group.joints[0];
    FreeAxis& free_axis = joint.free_axes[0];
    const int row = joint.first_free_axis();
    const auto again = [&] {
        const WarmStartCache kept = save_forces(joint, group.bodies[0], group.bodies[1], h);
        free_axis.at_limit = 7;
        free_axis.actuation = 7;
        joint.force[row] = 0;
        load_forces(joint, group.bodies[0], group.bodies[1], kept, h);
        return kept.free_axes[0];
    };
    // On the lower limit, pressed on by the motor less friction.
    free_axis.at_limit = 1;
    free_axis.actuation = 2;
    joint.force[row] = 5;
    WarmStartCache::FreeAxisImpulses kept = again();
    EXPECT_DOUBLE_EQ(kept.lower, 10 * h);
    EXPECT_DOUBLE_EQ(kept.motor + kept.friction, 6 * h);
    EXPECT_EQ(free_axis.at_limit, 1);
    EXPECT_EQ(free_axis.actuation, 2);
    EXPECT_DOUBLE_EQ(joint.force[row], 5);
    // Held at the motor's speed with 12 N, of which friction is at most 4.
    free_axis.at_limit = 0;
    free_axis.actuation = 3;
    joint.force[row] = -1;
    kept = again();
    EXPECT_DOUBLE_EQ(kept.motor + kept.friction, -2 * h);
    EXPECT_EQ(free_axis.actuation, 3);
    EXPECT_DOUBLE_EQ(joint.force[row], -1);
    for (const int actuation : {0, 2, 4}) {
        free_axis.actuation = actuation;
        again();
        EXPECT_EQ(free_axis.actuation, actuation);
        EXPECT_EQ(free_axis.at_limit, 0);
    }
}

}  // namespace
}  // namespace jostle::test
