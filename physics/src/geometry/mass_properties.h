// SPDX-License-Identifier: MIT
//
// Mass, centre of mass and inertia of each shape kind, from density. Closed forms of solid bodies.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

struct MassProperties {
    double mass = 0;                     // kg
    Vec3 center;                         // m
    Mat3 inertia = diagonal({0, 0, 0});  // kg m^2 about `center`
};

// In the shape's own frame. Planes, meshes and height fields have no mass.
MassProperties mass_of(const Geometry& geometry, double density);

// The same body seen from the parent of `pose`.
MassProperties moved(const MassProperties& properties, const Transform& pose);

// Two bodies as one (parallel axis theorem).
MassProperties combined(const MassProperties& a, const MassProperties& b);

}  // namespace jostle::physics
