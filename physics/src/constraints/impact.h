// SPDX-License-Identifier: MIT
//
// What two bodies do to each other at the moment when they meet, away from the solver's sub-steps:
// sequential impulses with restitution and Coulomb friction. Takes energy, never gives any.
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/mat3.h"
#include "physics/src/collision/narrowphase/impact_points.h"

namespace jostle::physics {

// A body at that moment; one that impulses cannot move has zero inverse mass and inertia.
struct ImpactBody {
    Vec3 center;                                 // m
    Vec3 inverse_mass;                           // 1/kg along each axis of the world
    Mat3 inverse_inertia = diagonal({0, 0, 0});  // 1/(kg m^2), world axes
    Vec3 v, w;                                   // m/s, rad/s
};

struct HardestPoint {
    double approach = 0;  // m/s; 0: nothing approaches
    ImpactPoint point;
    double normal_impulse = 0, friction_impulse = 0;  // N s, of all points
};

// Changes the velocities of both. Returns where they came at each other fastest, and what they did
// to each other.
HardestPoint resolve_impact(ImpactBody& a, ImpactBody& b, std::span<const ImpactPoint> points,
                            double restitution, double friction);

}  // namespace jostle::physics
