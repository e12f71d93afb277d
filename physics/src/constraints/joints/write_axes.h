// SPDX-License-Identifier: MIT
//
// Converts a slider, six-dof or wheel (axes_layout.h) between the double values of the world and
// its lane.
#pragma once

#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/constraints/joints/joint_step.h"
#include "physics/src/constraints/joints/path_curve.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// Whether the impulse at the joint's point rotates with a although b is movable: if b's point can
// slide, it pushes along a's axes.
bool turns_with_a(const JointKind& kind);

// Returns the rows that the joint uses (JointUses), four bits per axis. h: sub-step, s.
// `path_point`: the position of b on a path, where a's arm then ends; null for other kinds.
std::uint32_t write_axes(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                         const PathPoint* path_point, JointAxesWide& to, const JointLane& lane);
void read_axes(Joint& joint, const JointAxesWide& from, double dt, const JointLane& lane);

}  // namespace jostle::physics
