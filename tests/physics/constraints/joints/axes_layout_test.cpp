// SPDX-License-Identifier: MIT
//
// Kinds as six axes, and the angles of a gimbal.
#include "physics/src/constraints/joints/axes_layout.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

Quat about(int axis, double angle) {
    const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return from_axis_angle(axes[axis], angle);
}

TEST(GimbalAngles, match_sequential_rotations) {
    const Quat frame = unit(Quat{0.1, 0.5, -0.3, 0.7});
    const GimbalAngles turns =
        gimbal_angles(frame, frame * about(0, 2.5) * about(1, -0.7) * about(2, -3));
    EXPECT_NEAR(turns.first, 2.5, 1e-12);
    EXPECT_NEAR(turns.middle, -0.7, 1e-12);
    EXPECT_NEAR(turns.last, -3, 1e-12);
}

// A small spin of b changes each angle by its row.
TEST(GimbalRows, match_the_angle_rates) {
    const Quat a = unit(Quat{0.1, 0.5, -0.3, 0.7});
    const Quat b = a * about(0, 0.5) * about(1, 0.9) * about(2, -1);
    const GimbalRows rows = gimbal_rows(a, b);
    const GimbalAngles before = gimbal_angles(a, b);
    for (const Vec3 spin : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const double h = 1e-6;
        const GimbalAngles after = gimbal_angles(a, from_rotation_vector(spin * h) * b);
        EXPECT_NEAR((after.first - before.first) / h, dot(rows.first, spin), 1e-5);
        EXPECT_NEAR((after.middle - before.middle) / h, dot(rows.middle, spin), 1e-5);
        EXPECT_NEAR((after.last - before.last) / h, dot(rows.last, spin), 1e-5);
    }
}

// Each of the six axes is found where the layout says, whichever turn is the middle one.
TEST(AxesLayout, six_dof_puts_a_locked_rotation_in_the_middle) {
    const JointAxis free{.free = true};
    const struct {
        SixDofAxes axes;
        int middle;
    } cases[] = {{{}, 1},
                 {{.rotation_x = free, .rotation_z = free}, 1},
                 {{.rotation_x = free, .rotation_y = free}, 2},
                 {{.rotation_y = free}, 2},
                 {{.rotation_y = free, .rotation_z = free}, 0},
                 {{.rotation_x = free, .rotation_y = free, .rotation_z = free}, 1}};
    for (const auto& [axes, middle] : cases) {
        EXPECT_EQ(middle_turn(axes), middle);
        const AxesLayout layout = layout_of(SixDofJoint{axes});
        EXPECT_EQ(layout.slots[4], 3 + middle);
        for (int axis = 0; axis < 3; axis++) {
            Transform b{{}, about(axis, 0.2)};
            (axis == 0 ? b.position.x : (axis == 1 ? b.position.y : b.position.z)) = 0.5;
            const AxesPose pose = pose_of(layout, {}, b);
            const double offsets[] = {pose.offset.x, pose.offset.y, pose.offset.z};
            const double turns[] = {pose.turns.first, pose.turns.middle, pose.turns.last};
            for (std::size_t k = 0; k < 3; k++) {
                EXPECT_NEAR(offsets[k], layout.slots[k] == axis ? 0.5 : 0, 1e-12);
                EXPECT_NEAR(turns[k], layout.slots[k + 3] == axis + 3 ? 0.2 : 0, 1e-12);
            }
        }
    }
}

TEST(AxesLayout, wheel_rests_at_its_steering_angle) {
    const AxesLayout layout = layout_of(WheelJoint{.steering = 0.3});
    const AxesPose pose = pose_of(layout, {}, {{0.1, 0.2, 0}, about(1, 0.3) * about(2, 1.5)});
    EXPECT_NEAR(pose.turns.first, 0, 1e-12);
    EXPECT_NEAR(pose.turns.middle, 0, 1e-12);
    EXPECT_NEAR(pose.turns.last, 1.5, 1e-12);
    EXPECT_NEAR(pose.offset.x, 0.2, 1e-12) << "the suspension";
    EXPECT_NEAR(locked_error(layout, pose), 0.1, 1e-12);
}

TEST(AxesLayout, slider_leaves_its_z_axis_free) {
    const AxesLayout layout = layout_of(SliderJoint{});
    EXPECT_NEAR(locked_error(layout, pose_of(layout, {}, {{0.3, 0.4, 7}, {}})), 0.5, 1e-12);
}

}  // namespace
}  // namespace jostle::test
