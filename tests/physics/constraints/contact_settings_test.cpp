// SPDX-License-Identifier: MIT
//
// The numbers of a step: sub-steps of each tier, and a softness that belongs to their length.
#include "physics/src/constraints/contact_settings.h"

#include <gtest/gtest.h>

#include "physics/src/constraints/softness.h"
#include "tests/support/step_time.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ContactSettings, substeps_add_up_to_the_step) {
    for (const SolverTier tier : all_tiers) {
        const ContactSettings set = contact_settings(dt, substeps_of(tier, {}), tier);
        EXPECT_EQ(set.substeps, substeps_of(tier, {}));
        EXPECT_NEAR(double{set.h} * set.substeps, dt, 1e-9);
        EXPECT_NEAR(double{set.h} * double{set.inverse_h}, 1, 1e-6);
    }
}

// A low contact swings at 0.36 of the sub-step rate, ten times overdamped: at 480 Hz, 172.8 Hz.
TEST(ContactSettings, stiffness_scales_with_the_substep_rate) {
    const ContactSettings set = contact_settings(dt, 8, SolverTier::low);
    const Softness expected = soft(0.36 * 480, 10, dt / 8);
    EXPECT_NEAR(double{set.bias_rate} * double{set.mass_scale}, expected.position_rate,
                1e-4 * expected.position_rate);
    EXPECT_NEAR(double{set.mass_scale}, expected.velocity_scale, 1e-6);
    EXPECT_NEAR(double{set.impulse_scale}, expected.impulse_scale, 1e-6);
    const ContactSettings twice = contact_settings(dt, 16, SolverTier::low);
    EXPECT_NEAR(double{twice.bias_rate}, 2 * double{set.bias_rate}, 1e-3 * double{set.bias_rate});
    EXPECT_NEAR(double{twice.mass_scale}, double{set.mass_scale}, 1e-6) << "the same per sub-step";
}

// Moments learned point by point would make a tower sway; short sub-steps need one sweep to relax.
TEST(ContactSettings, low_tiers_average_per_point_and_tall_tiers_per_manifold) {
    for (const SolverTier tier : all_tiers) {
        const ContactSettings set = contact_settings(dt, substeps_of(tier, {}), tier);
        EXPECT_EQ(set.per_point, tier <= SolverTier::pile ? 1 : 0);
        EXPECT_EQ(set.relax_sweeps, tier < SolverTier::tall ? 2 : 1);
    }
}

// The mean impulse follows over half a second: 1/30 of the difference a step, and all of it in
// steps that are longer.
TEST(ContactSettings, mean_impulse_converges_within_its_time_constant) {
    EXPECT_NEAR(double{contact_settings(dt, 8, SolverTier::low).mean_rate}, 1.0 / 30, 1e-7);
    EXPECT_NEAR(double{contact_settings(dt, 16, SolverTier::tall).mean_rate}, 1.0 / 120, 1e-7);
    EXPECT_LE(double{contact_settings(0.25, 8, SolverTier::low).mean_rate}, 1);
}

}  // namespace
}  // namespace jostle::test
