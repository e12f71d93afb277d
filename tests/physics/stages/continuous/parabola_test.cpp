// SPDX-License-Identifier: MIT
//
// Bodies that fall meet where their parabolas do, not where the chords of their steps do.
#include "physics/src/stages/continuous/parabola.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double flight = 1.0 / 30, g = 9.81;

// In the middle of the step a falling body is g flight^2 / 8 above its chord; at both ends it is on
// it. A little later it has fallen on.
TEST(Parabola, differs_from_its_chord) {
    const Vec3 gain{0, -g * flight, 0};
    EXPECT_NEAR(off_the_chord({gain}, 0.5, {}, 0, flight).y, g * flight * flight / 8, 1e-15);
    EXPECT_EQ(length(off_the_chord({gain}, 0, {}, 0, flight)), 0);
    EXPECT_EQ(length(off_the_chord({gain}, 1, {}, 0, flight)), 0);
    EXPECT_NEAR(off_the_chord({gain, 0.5}, 0.75, {}, 0, flight).y, g * flight * flight / 32, 1e-15);
    const double late = 0.001;
    EXPECT_NEAR(off_the_chord({gain}, 0, {1, -2, 0}, late, flight).y,
                -2 * late - 0.5 * g * late * late, 1e-15);
}

// A ball falls at 1 m/s when the step begins. At its fraction 0.5 its chord meets a floor; then it
// is where its parabola meets that floor, with the speed of that height.
TEST(Parabola, ball_has_the_analytic_impact_speed) {
    const Vec3 gain{0, -g * flight, 0};
    const double chord = -(1 + 0.5 * g * flight) * flight * 0.5;  // from where the step began
    ImpactBody floor,
        ball{
            .center = {0, chord, 0}, .inverse_mass = {1, 1, 1}, .v = {0, -1 - 0.5 * g * flight, 0}};
    std::vector<ImpactPoint> points{{{0, chord - 0.1, 0}, {0, 1, 0}}};
    put_on_parabolas(floor, {}, ball, {gain}, points, 0.5, flight);
    EXPECT_NEAR(ball.center.y, chord, 1e-12);
    EXPECT_NEAR(ball.v.y, -square_root(1 - 2 * g * chord), 1e-12);
    EXPECT_TRUE(near(points[0].position, {0, chord - 0.1, 0}, 1e-12));
    EXPECT_EQ(floor.center, Vec3{});
}

// What falls side by side meets as if nothing fell, a little higher.
TEST(Parabola, bodies_in_equal_free_fall_keep_their_relative_velocity) {
    const Vec3 gain{0, -g * flight, 0};
    ImpactBody a{.center = {-0.1, 0, 0}, .inverse_mass = {1, 1, 1}, .v = {2, 0, 0}},
        b{.center = {0.1, 0, 0}, .inverse_mass = {1, 1, 1}, .v = {-2, 0, 0}};
    std::vector<ImpactPoint> points{{{0, 0, 0}, {1, 0, 0}}};
    put_on_parabolas(a, {gain}, b, {gain}, points, 0.5, flight);
    EXPECT_TRUE(near(a.v, {2, 0, 0}, 1e-12));
    EXPECT_TRUE(near(b.v, {-2, 0, 0}, 1e-12));
    EXPECT_NEAR(a.center.y, g * flight * flight / 8, 1e-12);
    EXPECT_NEAR(b.center.y, g * flight * flight / 8, 1e-12);
}

}  // namespace
}  // namespace jostle::test
