// SPDX-License-Identifier: MIT
//
// The lane of a slider, a six-dof or a wheel (axes_layout.h), from the doubles of the world and
// back.
#pragma once

#include "physics/src/constraints/joints/joint_end.h"
#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/constraints/joints/path_curve.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// Whether the impulse at the joint's point turns with a although b moves: where b's point may
// slide, it pushes along a's axes.
bool turns_with_a(const JointKind& kind);

// Returns which rows it uses (JointUses), four bits for each axis. h: sub-step, s.
// `place`: where b is on a path, of which a's arm ends there; null for other kinds.
std::uint32_t write_axes(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                         const PathPoint* path_point, JointAxesWide& to, const JointLane& lane);
void read_axes(Joint& joint, const JointAxesWide& from, double dt, const JointLane& lane);

}  // namespace jostle::physics
