// SPDX-License-Identifier: MIT
#include "modules/ragdoll/src/rotation_interpolation.h"

#include <gtest/gtest.h>

namespace jostle::modules {
namespace {

using namespace physics;

TEST(RotationInterpolation, rotation_vector_round_trips) {
    for (const Vec3 r : {Vec3{0.3, -0.2, 0.9}, {1e-9, 0, 0}, {0, 3.1, 0}, {}}) {
        const Vec3 back = rotation_vector(from_rotation_vector(r));
        EXPECT_NEAR(length(back - r), 0, 1e-12);
    }
    const Vec3 shorter = rotation_vector(from_rotation_vector({0, 0, 4}));
    EXPECT_NEAR(shorter.z, 4 - 2 * pi, 1e-12);
}

TEST(RotationInterpolation, midpoint_interpolation_halves_the_angle) {
    const Quat from = from_axis_angle({0, 1, 0}, 0.4), to = from_axis_angle({0, 1, 0}, 1.0);
    EXPECT_NEAR(length(rotation_vector(interpolate(from, to, 0.5))), 0.7, 1e-12);
    EXPECT_NEAR(angle_about_z(from_axis_angle({0, 0, 1}, -2.5)), -2.5, 1e-12);
}

TEST(RotationInterpolation, transform_times_its_inverse_is_identity) {
    const Transform t{{1, 2, 3}, from_axis_angle({1, 1, 0}, 0.8)};
    const Transform none = compose(t, inverse(t));
    EXPECT_NEAR(length(none.position), 0, 1e-12);
    EXPECT_NEAR(none.rotation.w, 1, 1e-12);
}

}  // namespace
}  // namespace jostle::modules
