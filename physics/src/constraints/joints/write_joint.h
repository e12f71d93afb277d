// SPDX-License-Identifier: MIT
//
// A joint's lane in a block, from the doubles of the world and back.
#pragma once

#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraints/joints/joint_end.h"
#include "physics/src/constraints/joints/joint_step.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// The hot index of the body with which the impulse at a joint's point turns; 0 or less when nothing
// can move either: bodies without shapes have no mass. Where a point is free to slide along axes of
// a, that is a, whatever b does.
std::int32_t carrier_of(const JointKind& kind, std::int32_t a, std::int32_t b);

// Where a joint's lane is: a block, and what its kind has besides, or null.
struct JointBlock {
    JointConstraintWide& block;
    JointAngularWide* angular;
    VelocityRowWide* row;
    JointAxesWide* axes;
    JointGearWide* gear;
    JointConstraintWideMeta& meta;
};

// h: sub-step, s. Of gears, racks and pulleys write_gear() (gear_ends.h) writes the rest.
void write_joint(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                 const JointBlock& to, int lane);
// Impulses, and the mean loads over a step of dt seconds, into the joint; `carried` is the rotation
// of its carrier at the start of the step, or none. Returns whether it is loaded more than it
// bears.
// Whether what acted in the last step is more than it bears.
bool exceeds_break_limit(const Joint& joint);
bool read_joint(Joint& joint, Quat carried, double dt, const JointBlock& from, int lane);

}  // namespace jostle::physics
