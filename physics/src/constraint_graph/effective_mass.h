// SPDX-License-Identifier: MIT
//
// Effective masses of a manifold: the response of its bodies to impulses along its normals, along
// its tangents and about its normal.
#pragma once

#include "jostle/physics/mat3.h"
#include "physics/src/constraint_graph/contact_constraint_wide.h"

namespace jostle::physics {

// Inverse mass of one body of the pair. All zero if contacts cannot push the body.
struct InverseMass {
    Vec3 linear;                         // 1/kg, along each world axis
    Mat3 angular = diagonal({0, 0, 0});  // 1/(kg m^2), world axes
};

// The frame of a manifold in world axes, with arms from the centres of mass.
struct ContactFrame {
    Vec3 normal, tangent, arm_a, arm_b;
};

// Writes only the floats of the given lane.
void write_effective_mass(const ContactLaneRef& lane_ref, const ContactFrame& frame,
                          const InverseMass& a, const InverseMass& b);
// Recomputes the effective mass after the mass of one of the bodies changed.
void rewrite_effective_mass(const ContactLaneRef& lane_ref, const InverseMass& a,
                            const InverseMass& b);

}  // namespace jostle::physics
