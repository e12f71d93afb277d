// SPDX-License-Identifier: MIT
//
// Converts a joint between the double values of the world and its lane in a block.
#pragma once

#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraints/joints/joint_step.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// The hot index of the body that the impulse at a joint's point rotates with. 0 or negative if
// neither body is movable: bodies without shapes have no mass. If the point can slide along axes of
// a, the carrier is a, regardless of b.
std::int32_t carrier_of(const JointKind& kind, std::int32_t a, std::int32_t b);

// The target of a joint's lane: a block and the kind-specific data, or null.
struct JointBlock {
    JointConstraintWide& block;
    JointAngularWide* angular;
    VelocityRowWide* row;
    JointAxesWide* axes;
    JointGearWide* gear;
    JointConstraintWideMeta& meta;
};

// h: sub-step, s. For gears, racks and pulleys write_gear() (gear_ends.h) writes the remaining
// data.
void write_joint(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                 const JointBlock& to, int lane);
// Whether the load of the last step exceeds the joint's limits.
bool exceeds_break_limit(const Joint& joint);
// Stores the impulses and the mean loads over a step of dt seconds in the joint. `carried`:
// rotation of its carrier at the start of the step, or identity. Returns whether the load exceeds
// the joint's limits.
bool read_joint(Joint& joint, Quat carried, double dt, const JointBlock& from, int lane);

}  // namespace jostle::physics
