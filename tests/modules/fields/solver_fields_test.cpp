// SPDX-License-Identifier: MIT
//
// The wind and water of the solver pass the tests of module fields.
#include <gtest/gtest.h>

#include "tests/modules/fields/fall.h"
#include "tests/modules/fields/floating.h"

namespace jostle::modules {
namespace {

void add_buoyancy(World& world, double drag, double damping) {
    test::must(world.create_field({.force = BuoyancyField{.drag = drag, .angular_drag = damping}}));
}

void add_uniform_wind(World& world, double drag) {
    test::must(world.create_field({.force = UniformWind{.drag = drag}}));
}

TEST(SolverFields, fall_in_still_air_follows_tanh) {
    const double ball = worst_fall_error(add_uniform_wind, ball_of_fall());
    const double box = worst_fall_error(add_uniform_wind, box_of_fall());
    RecordProperty("ball_error", std::to_string(ball));
    RecordProperty("box_error", std::to_string(box));
    EXPECT_LT(ball, 5e-3);
    EXPECT_LT(box, 5e-3);
}

TEST(SolverFields, draft_matches_archimedes) {
    for (const double density : {100.0, 400.0, 800.0}) {
        const double error = draft_error(add_buoyancy, density);
        RecordProperty("draft_error_" + std::to_string(static_cast<int>(density)),
                       std::to_string(error));
        EXPECT_NEAR(error, 0, 5e-3) << density;
    }
}

TEST(SolverFields, heave_period_matches_the_draft) {
    // m / rho g A = draft / g.
    const double expected = 2 * pi * square_root(0.2 / 9.81);
    const double period = heave_period(add_buoyancy, 400, 0.05);
    RecordProperty("heave_error", std::to_string(period / expected - 1));
    EXPECT_NEAR(period / expected, 1, 0.01);
}

TEST(SolverFields, box_floats_upright_exactly_when_gm_is_positive) {
    expect_upright_exactly_when_gm_is_positive(add_buoyancy);
}

}  // namespace
}  // namespace jostle::modules
