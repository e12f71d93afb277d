// SPDX-License-Identifier: MIT
//
// The impact of two bodies at the time of contact, outside the solver's sub-steps: sequential
// impulses with restitution and Coulomb friction. Removes energy, never adds any.
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/mat3.h"
#include "physics/src/collision/narrowphase/impact_points.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// A body at the time of impact. Inverse mass and inertia are zero if impulses cannot move it.
struct ImpactBody {
    Vec3 center;                                 // m
    Vec3 inverse_mass;                           // 1/kg along each world axis
    Mat3 inverse_inertia = diagonal({0, 0, 0});  // 1/(kg m^2), world axes
    Vec3 v, w;                                   // m/s, rad/s
};

struct HardestPoint {
    double approach = 0;  // m/s; 0 if no point approaches
    ImpactPoint point;
    double normal_impulse = 0, friction_impulse = 0;  // N s, sum over all points
};

// Changes the velocities of both bodies. Returns the point with the highest approach speed and the
// total impulses. `bounce_speed`: slower impacts do not bounce, m/s.
HardestPoint resolve_impact(ImpactBody& a, ImpactBody& b, std::span<const ImpactPoint> points,
                            double restitution, double friction,
                            double bounce_speed = tuning::restitution_speed);

}  // namespace jostle::physics
