// SPDX-License-Identifier: MIT
//
// Turns and angles in eight floats against the same in doubles.
#define JOSTLE_SCALAR
#define JOSTLE_ISA scalar_for_tests
#include "physics/src/math/wide_rotation.h"

#include <gtest/gtest.h>

#include "jostle/physics/quat.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
namespace wide = physics::scalar_for_tests;
using namespace physics;

TEST(WideTurn, rotation_vectors_up_to_three_turns_match_double_precision) {
    Random random(8);
    for (int k = 0; k < 100000; k++) {
        const Vec3 r = random.direction() * (random.in(0, 1) * random.in(0, 1) * 6 * pi);
        const Vec3 v = random.direction();
        const auto splat = [](Vec3 x) {
            return wide::Wide3{wide::splat(static_cast<float>(x.x)),
                               wide::splat(static_cast<float>(x.y)),
                               wide::splat(static_cast<float>(x.z))};
        };
        const wide::Wide3 got = wide::rotate(wide::from_rotation_vector(splat(r)), splat(v));
        const Vec3 want = rotate(from_rotation_vector(r), v);
        ASSERT_NEAR(double{got.x[3]}, want.x, 3e-6) << length(r);
        ASSERT_NEAR(double{got.y[3]}, want.y, 3e-6) << length(r);
        ASSERT_NEAR(double{got.z[3]}, want.z, 3e-6) << length(r);
    }
}

TEST(WideTurn, angles_are_accurate_to_4e_7) {
    Random random(9);
    for (int k = 0; k < 100000; k++) {
        const float y = static_cast<float>(random.in(-1, 1)),
                    x = static_cast<float>(random.in(-1, 1));
        ASSERT_NEAR(double{wide::arc_tangent(wide::splat(y), wide::splat(x))[0]},
                    arc_tangent(double{y}, double{x}), 4e-7)
            << y << ", " << x;
    }
    EXPECT_EQ(wide::arc_tangent(wide::splat(0), wide::splat(0))[0], 0);
}

}  // namespace
}  // namespace jostle::test
