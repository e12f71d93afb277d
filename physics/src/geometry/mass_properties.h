// SPDX-License-Identifier: MIT
//
// Mass, centre of mass and inertia of each shape kind with a given density. Closed forms of solid
// bodies.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

struct MassProperties {
    double mass = 0;                     // kg
    Vec3 center;                         // centre of mass, m
    Mat3 inertia = diagonal({0, 0, 0});  // kg m^2 about `center`
};

// Mass properties in the shape's local frame. Zero for planes, meshes and height fields.
MassProperties mass_of(const Geometry& geometry, double density);

// Transforms mass properties from the local frame to its parent.
MassProperties moved(const MassProperties& properties, const Transform& pose);

// Mass properties of two bodies as one (parallel axis theorem).
MassProperties combined(const MassProperties& a, const MassProperties& b);

}  // namespace jostle::physics
