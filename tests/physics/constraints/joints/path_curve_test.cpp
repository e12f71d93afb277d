// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/path_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::test {
namespace {
using namespace physics;

PathJoint square_loop() {
    return {.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, .closed = true};
}

TEST(PathCurve, parameter_counts_laps) {
    const PathJoint path = square_loop();
    const double at = follow_path(path, {0.5, -0.05, 0}, 7.9);
    EXPECT_NEAR(at, 8.5, 0.1);
    const std::vector<double> travels = piece_travels(path);
    EXPECT_NEAR(travel_at(path, travels, 8.5), 2 * travels.back() + travel_at(path, travels, 0.5),
                1e-12);
    EXPECT_NEAR(path_point_at(path, 0.5).travel, travel_at(path, travels, 0.5), 1e-12);
}

// By symmetry both sides of a corner of the loop curve alike; where a straight piece begins, the
// curvature jumps.
TEST(PathCurve, curvature_jumps_between_unlike_pieces) {
    EXPECT_LT(curvature_jumps(square_loop(), 0.5, 3.5), 1e-12);
    const PathJoint bent{.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}, {4, 1, 0}}};
    EXPECT_EQ(curvature_jumps(bent, 0.2, 0.9), 0);
    EXPECT_GT(curvature_jumps(bent, 1.5, 2.5), 0.1);
    EXPECT_EQ(curvature_jumps(bent, 1.5, 2.5), curvature_jumps(bent, 2.5, 1.5));
    EXPECT_GT(
        curvature_jumps({.points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, .smooth = false}, 0.9, 1.1),
        1e6)
        << "a kink";
}

}  // namespace
}  // namespace jostle::test
