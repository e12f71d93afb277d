// SPDX-License-Identifier: MIT
//
// The numbers of one step that every contact shares.
#pragma once

#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

struct ContactSettings {
    int substeps = 0;
    int soft_sweeps = 0, relax_sweeps = 0;  // over the points of a manifold, per pass
    bool planar = false;                    // the kernels of constraints/planar_kernel.h run
    float h = 0, inverse_h = 0;             // sub-step, s
    float bias_rate = 0;                    // 1/s: how fast overlap is pushed out
    float mass_scale = 0;                   // 1 is rigid
    float impulse_scale = 0;  // fraction of its deviation from the mean_impulse impulse that a soft
                              // contact gives up per sub-step
    // What is squeezed, by this share of the way from the first body's middle to where they touch,
    // gives up as much in the relaxing pass, and learns no more.
    float squeezed = 0;
    float push_speed = 0;  // m/s
    float slop = 0;        // m of overlap aimed at
    float mean_rate = 0;  // share of the mean_impulse impulse that follows the present one per step
    float per_point = 0;  // 1: that of each point; 0: their mean
    float rebuild_drift = 0;          // m of relative motion after which a manifold is rebuilt
    float rebuild_motion = 0;         // m in one step after which it is rebuilt, too
    float single_rebuild_motion = 0;  // ... of one point
    float touch_gap = 0;              // m
    float restitution_speed = 0;      // m/s
    float gravity_ratio = 1;          // over the usual one; 1 where there is none
};

// Soft contact after Catto ("Soft Constraints", GDC 2011): frequency in proportion to the sub-step
// rate, so that more sub-steps are stiffer and more exact.
// For islands of this tier.
ContactSettings contact_settings(double dt, int substeps, SolverTier tier);
// ... as stiff as for `stiff_as` sub-steps.
ContactSettings contact_settings(double dt, int substeps, SolverTier tier, int stiff_as);

}  // namespace jostle::physics
