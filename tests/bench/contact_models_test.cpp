// SPDX-License-Identifier: MIT
//
// Known properties of each contact model, in numbers.
#include "bench/contact_models/contact_models.h"

#include <gtest/gtest.h>

namespace {

using namespace jostle::bench::contact_models;

SceneErrors errors_of(const char* model, double rate_hz) {
    return contact_model_row(*find_contact_model(model), rate_hz).errors;
}

TEST(Penalty, penetration_matches_the_spring_and_long_steps_are_unstable) {
    EXPECT_TRUE(errors_of("penalty", 60).failed);
    const SceneErrors fine = errors_of("penalty", 3840);
    ASSERT_FALSE(fine.failed);
    EXPECT_NEAR(fine.overlap, 10 * mass * gravity / 1e5, 5e-6);  // m g / k of ten balls
    EXPECT_LT(fine.slide, 0.005);
}

// The allowed overlap is 0.5 mm. At 30 Hz ten iterations are not enough for ten balls.
TEST(Impulses, leave_the_allowed_penetration) {
    for (const double rate : {60.0, 120.0, 480.0}) {
        const SceneErrors errors = errors_of("impulses", rate);
        ASSERT_FALSE(errors.failed);
        EXPECT_LT(errors.overlap, 0.0006) << rate;
    }
    EXPECT_LT(errors_of("impulses", 960).energy, 0.02);
}

TEST(Xpbd, is_stable_at_any_step_and_converges_at_first_order) {
    EXPECT_FALSE(errors_of("xpbd", 30).failed);
    const SceneErrors coarse = errors_of("xpbd", 120), fine = errors_of("xpbd", 480);
    EXPECT_LT(fine.slide, 0.5 * coarse.slide);
    EXPECT_LT(fine.energy, 0.5 * coarse.energy);
    EXPECT_LT(fine.overlap, 1e-4);
}

TEST(ContactModels, all_models_match_the_coulomb_stopping_distance) {
    for (const ContactModelKind& kind : contact_model_kinds())
        EXPECT_LT(contact_model_row(kind, 1920).errors.slide, 0.01) << kind.name;
}

}  // namespace
