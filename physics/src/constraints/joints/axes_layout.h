// SPDX-License-Identifier: MIT
//
// Sliders, six-dofs and wheels as what they have in common: three translations of b's origin along
// the axes of a frame of a, and three turns one after the other, each locked or with a limit, a
// spring, a motor and friction. In double; the kernel for eight at a time is axes_kernel.h.
#pragma once

#include <array>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraints/joints/path_curve.h"

namespace jostle::physics {

// The turn of one frame against another as three angles: about the first axis (x) of frame_a, about
// the middle one, across both others, and about the last (z) of frame_b. The middle angle is within
// a quarter turn.
struct GimbalAngles {
    double first = 0, middle = 0, last = 0;  // rad
};
GimbalAngles gimbal_angles(Quat frame_a, Quat frame_b);

// How fast each angle changes is its row times the spin of b against a; a torque along a row works
// at that angle alone. Beyond a middle angle of 87 degrees the rows stay as they are there.
struct GimbalRows {
    Vec3 first, middle, last;  // world
};
GimbalRows gimbal_rows(Quat frame_a, Quat frame_b);

// A kind in those terms.
struct AxesLayout {
    // From the joint's frames to those whose axes the translations and turns are about.
    Quat turn_a, turn_b;
    std::array<JointAxis, 6> axes;  // translations, turns first, middle, last
    // Which of the axis' impulses in Joint::memory are its own (constraint_graph/joint_memory.h);
    // -1: it is always locked.
    std::array<int, 6> slots{-1, -1, -1, -1, -1, -1};
};
AxesLayout layout_of(const SliderJoint& slider);
AxesLayout layout_of(const SixDofJoint& six);
AxesLayout layout_of(const WheelJoint& wheel);
// Where the bead is: the first axis is along the curve there, and counts from there.
AxesLayout layout_at(const PathJoint& path, const PathPoint& path_point);

// Where b is against a, in the layout's terms.
struct AxesPose {
    Vec3 offset;         // m, of b's origin in a's frame
    GimbalAngles turns;  // rad
};
AxesPose pose_of(const AxesLayout& layout, const Transform& frame_a, const Transform& frame_b);
// How far what is locked is from where it should be, m.
double locked_error(const AxesLayout& layout, const AxesPose& pose);

// Which of x, y, z is the middle turn of a six-dof: 0, 1 or 2.
int middle_turn(const SixDofAxes& axes);

}  // namespace jostle::physics
