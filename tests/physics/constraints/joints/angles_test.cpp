// SPDX-License-Identifier: MIT
//
// Angles between the two frames of a joint.
#include "physics/src/constraints/joints/angles.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

// Wherever both stand, b turned against a about their common z axis.
TEST(JointAngles, hinge_angle_is_the_rotation_about_z) {
    Random random(191);
    for (const double angle : {-3.1, -1.0, 0.0, 0.3, 2.0, 3.1}) {
        const Quat a = random.rotation();
        EXPECT_NEAR(hinge_angle(a, a * from_axis_angle({0, 0, 1}, angle)), angle, 1e-12);
        EXPECT_NEAR(hinge_angle(a * from_axis_angle({0, 0, 1}, angle), a), -angle, 1e-12);
    }
}

// A swing by 0.7 rad about some axis square to x, after a twist about x: both are found again.
TEST(JointAngles, swing_and_twist_are_separated) {
    Random random(192);
    for (const double twist : {-3.0, -0.5, 0.0, 1.2, 3.0}) {
        const Quat a = random.rotation();
        const double direction = random.in(0, 6);
        const SinCos d = sin_cos(direction);
        const Quat b =
            a * from_axis_angle({0, d.cos, d.sin}, 0.7) * from_axis_angle({1, 0, 0}, twist);
        EXPECT_NEAR(twist_angle(a, b), twist, 1e-12);
        EXPECT_NEAR(swing_angle(a, b), 0.7, 1e-12);
    }
}

// A quaternion and its negative are one rotation.
TEST(JointAngles, are_invariant_under_quaternion_sign) {
    const Quat a = from_axis_angle({1, 2, 3}, 0.4), b = a * from_axis_angle({1, 0, 0}, 2.5);
    const Quat negative{-b.x, -b.y, -b.z, -b.w};
    EXPECT_NEAR(twist_angle(a, negative), 2.5, 1e-12);
    EXPECT_NEAR(hinge_angle(a, negative), hinge_angle(a, b), 1e-12);
    EXPECT_NEAR(swing_angle(a, a), 0, 1e-9);
}

}  // namespace
}  // namespace jostle::test
