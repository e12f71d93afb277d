// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_settings.h"

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// An implicit spring of angular frequency omega and damping ratio zeta over a sub-step h changes
// the impulse to
//     lambda' = lambda - mass_scale (vn + bias_rate gap) / k - impulse_scale lambda,
// with a1 = 2 zeta + h omega, a2 = h omega a1, bias_rate = omega / a1, mass_scale = a2 / (1 + a2),
// impulse_scale = 1 / (1 + a2).
ContactSettings contact_settings(double dt, int substeps, SolverTier tier) {
    return contact_settings(dt, substeps, tier, {dt, substeps});
}

ContactSettings contact_settings(double dt, int substeps, SolverTier tier, StiffnessStep stiff_as) {
    ASSERT(substeps >= 1 && stiff_as.substeps >= 1);
    const bool low = tier <= SolverTier::pile;
    const double mean_impulse_time =
        low ? tuning::low_mean_impulse_time : tuning::mean_impulse_time;
    const double stiffness = tier == SolverTier::pile ? tuning::pile_contact_stiffness
                             : low                    ? tuning::low_contact_stiffness
                                                      : tuning::contact_stiffness;
    const double damping = tier == SolverTier::pile      ? tuning::pile_contact_damping_ratio
                           : tier == SolverTier::slender ? tuning::slender_contact_damping_ratio
                                                         : tuning::contact_damping_ratio;
    const double h = dt / substeps, omega = 2 * pi * stiffness * stiff_as.substeps / stiff_as.dt;
    const double a1 = 2 * damping + h * omega, a2 = h * omega * a1;
    ASSERT(h > 0 && omega > 0 && a1 > 0);
    const auto f = [](double x) { return static_cast<float>(x); };
    return {.substeps = substeps,
            .soft_sweeps = tuning::manifold_sweeps,
            .relax_sweeps = tier < SolverTier::tall ? tuning::manifold_sweeps : 1,
            .h = f(h),
            .inverse_h = f(1 / h),
            .bias_rate = f(omega / a1),
            .mass_scale = f(a2 / (1 + a2)),
            .impulse_scale = f(1 / (1 + a2)),
            .squeezed = f(low ? tuning::squeezed_share : tuning::never_squeezed),
            .push_speed = f(tuning::push_out_speed),
            .slop = f(tuning::contact_slop),
            .mean_rate = f(minimum(1, dt / mean_impulse_time)),
            .per_point = low ? 1.0f : 0.0f,
            .rebuild_drift = f(tuning::reuse_distance),
            .rebuild_motion = f(tuning::reuse_speed * dt),
            .single_rebuild_motion = f(tuning::single_reuse_speed * dt),
            .touch_gap = f(tuning::touch_gap),
            .restitution_speed = f(tuning::restitution_speed)};
}

}  // namespace jostle::physics
