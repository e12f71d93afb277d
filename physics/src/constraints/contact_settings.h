// SPDX-License-Identifier: MIT
//
// The parameters of one step that all contacts share.
#pragma once

#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

struct ContactSettings {
    int substeps = 0;
    int soft_sweeps = 0, relax_sweeps = 0;  // over the points of a manifold, per pass
    bool planar = false;                    // the kernels of constraints/planar_kernel.h run
    float h = 0, inverse_h = 0;             // sub-step, s
    float bias_rate = 0;                    // 1/s: rate at which overlap is pushed out
    float mass_scale = 0;                   // 1 is rigid
    // Fraction of the deviation from the mean impulse that a soft contact gives up per sub-step.
    float impulse_scale = 0;
    // A point is squeezed if its overlap exceeds this fraction of the distance from the first
    // body's centre to the contact. A squeezed point also gives up impulse in the relaxing pass,
    // and its mean impulse no longer rises.
    float squeezed = 0;
    float push_speed = 0;     // m/s
    float slop = 0;           // m, target overlap
    float mean_rate = 0;      // fraction by which the mean impulse follows the current one per step
    float per_point = 0;      // 1: mean impulse of each point; 0: their average
    float rebuild_drift = 0;  // m of relative motion after which a manifold is rebuilt
    float rebuild_motion = 0;         // m of motion in one step after which it is rebuilt
    float single_rebuild_motion = 0;  // the same for a manifold with one point
    float touch_gap = 0;              // m
    float restitution_speed = 0;      // m/s
    float gravity_ratio = 1;          // ratio to standard gravity; 1 without gravity
};

// Soft contact parameters for islands of this tier, after Catto ("Soft Constraints", GDC 2011). The
// frequency is proportional to the sub-step rate, so that more sub-steps are stiffer and more
// accurate.
ContactSettings contact_settings(double dt, int substeps, SolverTier tier);

// The step whose stiffness contacts have.
struct StiffnessStep {
    double dt;  // s
    int substeps;
};
// Same, with the stiffness of another step.
ContactSettings contact_settings(double dt, int substeps, SolverTier tier, StiffnessStep stiff_as);

}  // namespace jostle::physics
