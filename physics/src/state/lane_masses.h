// SPDX-License-Identifier: MIT
//
// Effective masses of a manifold: how its bodies answer to impulses along its normals, tangents and
// about its normal.
#pragma once

#include "state/world_state.h"

namespace jostle::physics {

// Where a manifold is: world axes, arms from the centres of mass.
struct LaneFrame {
    Vec3 normal, tangent, arm_a, arm_b;
};

// Writes only floats of the contact's own lane.
void write_masses(WorldState& world, const Contact& contact, const LaneFrame& frame);

// After the mass of one of its bodies changed.
void write_masses_anew(WorldState& world, const Contact& contact);

}  // namespace jostle::physics
