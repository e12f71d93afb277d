// SPDX-License-Identifier: MIT
//
// Effective masses of a manifold: how its bodies answer to impulses along its normals, along its
// tangents and about its normal.
#pragma once

#include "jostle/physics/mat3.h"
#include "physics/src/constraint_graph/contact_constraint_wide.h"

namespace jostle::physics {

// One body of the pair: all zero for what contacts cannot push.
struct InverseMass {
    Vec3 linear;                         // 1/kg, along each world axis
    Mat3 angular = diagonal({0, 0, 0});  // 1/(kg m^2), world axes
};

// Where a manifold is: world axes, arms from the centres of mass.
struct ContactFrame {
    Vec3 normal, tangent, arm_a, arm_b;
};

// Write only floats of the place's own lane.
void write_effective_mass(const ContactLaneRef& lane_ref, const ContactFrame& frame,
                          const InverseMass& a, const InverseMass& b);
// After the mass of one of its bodies changed.
void rewrite_effective_mass(const ContactLaneRef& lane_ref, const InverseMass& a,
                            const InverseMass& b);

}  // namespace jostle::physics
