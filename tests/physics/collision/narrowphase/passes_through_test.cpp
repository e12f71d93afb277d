// SPDX-License-Identifier: MIT
//
// Shapes that overlap only within a step, on straight and rotating paths.
#include "physics/src/collision/narrowphase/passes_through.h"

#include <gtest/gtest.h>

namespace jostle::physics {
namespace {

SweptShape moving(const Geometry& geometry, Vec3 from, Vec3 motion, Vec3 turn = {},
                  Vec3 offset = {}) {
    return {&geometry, offset, diagonal({1, 1, 1}), 3, {0, from, {}, motion, turn}};
}

const Geometry ball = Sphere{0.1}, plate = Box{{0.01, 1, 1}}, bar = Box{{2, 0.02, 0.02}};

TEST(PassesThrough, ball_crosses_a_plate_or_stops_before_it) {
    const SweptShape still = moving(plate, {}, {});
    EXPECT_TRUE(passes_through(still, moving(ball, {-5, 0, 0}, {10, 0, 0}), 0, 1));
    EXPECT_FALSE(passes_through(still, moving(ball, {-5, 0, 0}, {4.8, 0, 0}), 0, 1));
    EXPECT_FALSE(passes_through(still, moving(ball, {-5, 0, 0}, {10, 0, 0}), 0, 0.4));
    EXPECT_FALSE(passes_through(still, moving(ball, {-5, 0, 0}, {10, 0, 0}), 0.6, 1));
}

TEST(PassesThrough, ball_that_grazes_an_edge_by_a_tenth_of_a_millimetre) {
    const SweptShape still = moving(plate, {}, {});
    EXPECT_TRUE(passes_through(still, moving(ball, {-5, 1.0999, 0}, {10, 0, 0}), 0, 1));
    EXPECT_FALSE(passes_through(still, moving(ball, {-5, 1.1001, 0}, {10, 0, 0}), 0, 1));
}

TEST(PassesThrough, ball_that_starts_at_the_surface_counts_only_if_it_moves_inwards) {
    const SweptShape still = moving(plate, {}, {});
    EXPECT_TRUE(passes_through(still, moving(ball, {-0.11, 0, 0}, {1, 0, 0}), 0, 1));
    EXPECT_FALSE(passes_through(still, moving(ball, {-0.11, 0, 0}, {-1, 0, 0}), 0, 1));
}

// Both ends of the bar are far from the ball at the start and at the end of a half turn.
TEST(PassesThrough, bar_sweeps_over_a_ball) {
    const SweptShape turning = moving(bar, {}, {}, {0, 0, pi});
    EXPECT_TRUE(passes_through(turning, moving(ball, {0, 1.5, 0}, {}), 0, 1));
    EXPECT_FALSE(passes_through(turning, moving(ball, {0, 2.2, 0}, {}), 0, 1));
    EXPECT_FALSE(passes_through(turning, moving(ball, {0, 1.5, 0}, {}), 0, 0.4));
}

}  // namespace
}  // namespace jostle::physics
