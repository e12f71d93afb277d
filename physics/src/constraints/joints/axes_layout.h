// SPDX-License-Identifier: MIT
//
// Common form of sliders, six-dofs and wheels: three translations of b's origin along the axes of a
// frame of a, and three successive rotations. Each is locked or has a limit, a spring, a motor and
// friction. In double; axes_kernel.h is the kernel for eight joints.
#pragma once

#include <array>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraints/joints/path_curve.h"

namespace jostle::physics {

// The rotation between two frames as three angles: about the first axis (x) of frame_a, about the
// middle axis, which is perpendicular to both others, and about the last axis (z) of frame_b. The
// middle angle is within 90 degrees.
struct GimbalAngles {
    double first = 0, middle = 0, last = 0;  // rad
};
GimbalAngles gimbal_angles(Quat frame_a, Quat frame_b);

// The rate of each angle is its row times the spin of b relative to a. A torque along a row affects
// only that angle. The rows are constant beyond a middle angle of 87 degrees.
struct GimbalRows {
    Vec3 first, middle, last;  // world
};
GimbalRows gimbal_rows(Quat frame_a, Quat frame_b);

// A joint kind in this form.
struct AxesLayout {
    // Rotations from the joint's frames to the frames of the translations and rotations.
    Quat turn_a, turn_b;
    std::array<JointAxis, 6> axes;  // translations, then rotations first, middle, last
    // Index of each axis's impulses in Joint::memory (constraint_graph/joint_memory.h); -1 for an
    // axis that is always locked.
    std::array<int, 6> slots{-1, -1, -1, -1, -1, -1};
};
AxesLayout layout_of(const SliderJoint& slider);
AxesLayout layout_of(const SixDofJoint& six);
AxesLayout layout_of(const WheelJoint& wheel);
// The layout at a point of a path: the first axis is tangential to the curve there and measured
// from there.
AxesLayout layout_at(const PathJoint& path, const PathPoint& path_point);

// The pose of b relative to a, in terms of the layout.
struct AxesPose {
    Vec3 offset;         // m, of b's origin in a's frame
    GimbalAngles turns;  // rad
};
AxesPose pose_of(const AxesLayout& layout, const Transform& frame_a, const Transform& frame_b);
// Error of the locked axes, m.
double locked_error(const AxesLayout& layout, const AxesPose& pose);

// The index (0, 1 or 2 for x, y, z) of the middle rotation of a six-dof.
int middle_turn(const SixDofAxes& axes);

}  // namespace jostle::physics
