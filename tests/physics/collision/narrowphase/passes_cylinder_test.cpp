// SPDX-License-Identifier: MIT
//
// Cylinders that pass triangles, against the distances of GJK along the way.
#include "physics/src/collision/narrowphase/triangle.h"

#include <gtest/gtest.h>

#include "physics/src/collision/narrowphase/gjk.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(PassesCylinder, reports_only_shapes_that_stay_separated) {
    Random random(7);
    int passed = 0, touched = 0, missed = 0;
    for (int round = 0; round < 3000; round++) {
        const Geometry geometry = Cylinder{random.in(0.2, 0.5), random.in(0.05, 0.3)};
        const Convex start =
            convex_of(transformed_shape(geometry, {random.vector(1), random.rotation()}), {});
        const Vec3 motion = start.axes.x * random.in(-1, 1) + start.axes.z * random.in(-1, 1);
        const Vec3 at = start.position + motion * random.in(0, 1) + random.vector(0.5);
        const Vec3 corner[3] = {at, at + random.vector(0.5), at + random.vector(0.5)};
        const bool passes = passes_cylinder(start, middle_of(start) + motion, motion, corner, 1e-6);
        double least = 1e300;
        for (int k = 0; k <= 20; k++) {
            Convex there = start;
            there.position += motion * (k / 20.0);
            least = minimum(least, gjk(triangle_convex(corner, {}, {}), there, {}).distance);
        }
        if (passes) {
            ASSERT_GT(least, 0) << "round " << round;
        }
        passed += passes ? 1 : 0;
        touched += least > 0 ? 0 : 1;
        missed += !passes && least > 1e-3 ? 1 : 0;
    }
    // Of those apart it may leave some to the search: what the cylinder moves away from.
    EXPECT_GT(passed, 500);
    EXPECT_GT(touched, 500);
    RecordProperty("left_to_the_search", missed);
}

}  // namespace
}  // namespace jostle::test
