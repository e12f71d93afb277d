// SPDX-License-Identifier: MIT
#include "jostle/modules/segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using namespace physics;

double distance_at(const std::array<Vec3, 4>& p, double s, double t) {
    return length(p[0] + (p[1] - p[0]) * s - (p[2] + (p[3] - p[2]) * t));
}

// No point of a grid on both segments is closer.
double least_on_grid(const std::array<Vec3, 4>& p) {
    constexpr int n = 200;
    double least = 1e300;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            least = std::min(least, distance_at(p, 1.0 * i / n, 1.0 * j / n));
    return least;
}

TEST(Segments, closest_points_are_at_least_as_close_as_those_of_a_grid) {
    test::Random random(7);
    for (int k = 0; k < 200; k++) {
        std::array<Vec3, 4> p;
        for (Vec3& each : p) each = random.vector(1);
        if (k % 5 == 1) p[3] = p[2] + (p[1] - p[0]) * 0.7;  // parallel
        if (k % 5 == 2) p[3] = p[2];                        // a point
        if (k % 5 == 3) p[1] = p[0];
        const auto [s, t] = closest_on_segments(p[0], p[1], p[2], p[3], 0.5);
        ASSERT_TRUE(s >= 0 && s <= 1 && t >= 0 && t <= 1) << k;
        EXPECT_LE(distance_at(p, s, t), least_on_grid(p) + 1e-12) << k;
    }
}

TEST(Segments, parallel_ones_meet_where_asked) {
    const auto [s, t] = closest_on_segments({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, 0.25);
    EXPECT_EQ(s, 0.25);
    EXPECT_EQ(t, 0.25);
}

}  // namespace
}  // namespace jostle::modules
