// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/triangle.h"

#include <gtest/gtest.h>

#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

// By a grid of 60 x 60 points of the triangle: none is nearer, and one is within its spacing.
TEST(NearestOnTriangle, no_other_point_is_nearer) {
    Random random(31);
    for (int round = 0; round < 3000; round++) {
        Vec3 corner[3] = {random.vector(1), random.vector(1), random.vector(1)};
        if (round % 10 == 0) corner[2] = corner[0] * 0.3 + corner[1] * 0.7;  // no area
        if (round % 30 == 0) corner[1] = corner[2] = corner[0];
        const Vec3 p = random.vector(2);
        const double found = length(p - nearest_on_triangle(corner, p));
        double least = 1e300;
        for (int i = 0; i <= 60; i++)
            for (int k = 0; i + k <= 60; k++)
                least = minimum(least, length(p - corner[0] - (corner[1] - corner[0]) * (i / 60.0) -
                                              (corner[2] - corner[0]) * (k / 60.0)));
        EXPECT_LE(found, least + 1e-12) << round;
        EXPECT_GE(found, least - 0.06) << round;
    }
}

TEST(NearestOnTriangle, is_the_point_itself_if_it_lies_on_the_triangle) {
    const Vec3 corner[3] = {{0, 0, 0}, {3, 0, 0}, {0, 0, 4}};
    const Vec3 inside{1, 0, 1}, corner_itself{3, 0, 0};
    EXPECT_NEAR(length(nearest_on_triangle(corner, inside) - inside), 0, 1e-15);
    EXPECT_EQ(nearest_on_triangle(corner, corner_itself), corner_itself);
    EXPECT_NEAR(length(nearest_on_triangle(corner, {1, 7, 1}) - inside), 0, 1e-15);
}

}  // namespace
}  // namespace jostle::test
