// SPDX-License-Identifier: MIT
//
// Where two segments are closest.
#include "physics/src/collision/narrowphase/segments.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr Vec3 x{1, 0, 0}, y{0, 1, 0};

TEST(Segments, crossing_segments_are_closest_at_the_crossing) {
    const SegmentPair p = closest_on_segments({}, x, 2, {0.5, 0.25, 3}, y, 1);
    EXPECT_NEAR(p.s, 0.5, 1e-12);
    EXPECT_NEAR(p.t, -0.25, 1e-12);
}

TEST(Segments, closest_point_beyond_an_end_is_the_end) {
    const SegmentPair p = closest_on_segments({}, x, 2, {5, 3, 0}, y, 1);
    EXPECT_EQ(p.s, 2);
    EXPECT_EQ(p.t, -1);
}

// From -2 to 2 and from 1 to 5: they share 1 to 2. Apart, their ends.
TEST(Segments, parallel_segments_use_the_middle_of_their_overlap) {
    for (const Vec3 v : {x, -x}) {
        const SegmentPair p = closest_on_segments({}, x, 2, {3, 1, 0}, v, 2);
        EXPECT_NEAR(p.s, 1.5, 1e-12);
        EXPECT_NEAR(3 + v.x * p.t, 1.5, 1e-12);
    }
    const SegmentPair apart = closest_on_segments({}, x, 2, {9, 1, 0}, x, 2);
    EXPECT_EQ(apart.s, 2);
    EXPECT_EQ(apart.t, -2);
}

TEST(Segments, no_grid_point_is_closer) {
    Random random(141);
    for (int round = 0; round < 500; round++) {
        const Vec3 a = random.vector(2), u = random.direction(), b = random.vector(2),
                   v = random.direction();
        const double ha = random.in(0.1, 2), hb = random.in(0.1, 2);
        const SegmentPair p = closest_on_segments(a, u, ha, b, v, hb);
        ASSERT_LE(absolute(p.s), ha);
        ASSERT_LE(absolute(p.t), hb);
        const double distance = length(a + u * p.s - b - v * p.t);
        for (int i = -10; i <= 10; i++)
            for (int k = -10; k <= 10; k++)
                ASSERT_GE(length(a + u * (ha * i / 10) - b - v * (hb * k / 10)), distance - 1e-9);
    }
}

// Rods of 0.2 m whose axes are 0.4 m apart and cross at 0.1 rad: that far on both sides of the
// crossing the axes are two ten-thousandths of the radius further from each other.
TEST(Segments, crossing_half_length_matches_the_opening_fraction_of_the_radius) {
    const double angle = 0.1, radius = 0.2, distance = 0.4;
    const SinCos turn = sin_cos(angle);
    const double half = half_of_crossing(distance, radius, turn.cos);
    const double there = square_root(distance * distance + half * half * turn.sin * turn.sin);
    EXPECT_NEAR((there - distance) / radius, 2e-4, 2e-6);
}

}  // namespace
}  // namespace jostle::test
