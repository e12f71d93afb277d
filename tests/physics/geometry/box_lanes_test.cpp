// SPDX-License-Identifier: MIT
//
// Boxes in float, against the exact tests in double: nothing that is met is left out.
#include "physics/src/geometry/box_lanes.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

Aabb random_box(Random& random, double far) {
    const Vec3 at = random.vector(far), half = abs(random.vector(1));
    return {at - half, at + half};
}

TEST(BoxLanes, floats_are_rounded_outwards) {
    Random random(3);
    for (int k = 0; k < 10000; k++) {
        const double d = random.in(-1, 1) * (k % 2 == 0 ? 1e4 : 1e-6);
        EXPECT_LT(double{float_below(d)}, d);
        EXPECT_GT(double{float_above(d)}, d);
        EXPECT_NEAR(double{float_below(d)}, d, 4e-7 * absolute(d) + 1e-36);
    }
    EXPECT_LT(float_below(1e300), float_above(1e300)) << "finite";
}

TEST(BoxLanes, find_overlaps_and_ray_hits) {
    Random random(4);
    int met = 0, beside = 0, entered = 0, passed = 0;
    for (int round = 0; round < 3000; round++) {
        const double far = round % 2 == 0 ? 2 : 1000;
        const Vec3 about = random.vector(far);
        Aabb box[4];
        BoxLanes lanes;
        for (int k = 0; k < 3; k++) {
            box[k] = random_box(random, 2);
            box[k] = {box[k].low + about, box[k].high + about};
            lanes.put(k, box[k]);
        }
        lanes.put_empty(3);
        Aabb one = random_box(random, 2);
        one = {one.low + about, one.high + about};
        const Vec3 origin = about + random.vector(4), towards = about - origin;
        const Vec3 motion =
            round % 5 == 0 ? Vec3{0, 2 * towards.y, 0} : towards * 2 + random.vector(1);
        Float4 enters;
        const unsigned overlaps = overlapping(broadcast(one), lanes);
        const unsigned rays = RayOverlap(origin, motion)(lanes, 1, enters);
        EXPECT_EQ(overlaps & 8, 0u);
        EXPECT_EQ(rays & 8, 0u);
        for (int k = 0; k < 3; k++) {
            const bool exactly = overlap(box[k], one);
            const double at = ray_enters(box[k], origin, motion, 1);
            if (exactly) {
                EXPECT_NE(overlaps & (1u << k), 0u);
            }
            if (at <= 1) {
                EXPECT_NE(rays & (1u << k), 0u);
            }
            met += exactly ? 1 : 0;
            beside += !exactly && (overlaps & (1u << k)) != 0 ? 1 : 0;
            entered += at <= 1 ? 1 : 0;
            passed += at > 1 && (rays & (1u << k)) != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(met, 500);
    EXPECT_GT(entered, 500);
    EXPECT_LT(beside + passed, 50) << "looked at for nothing";
}

}  // namespace
}  // namespace jostle::test
