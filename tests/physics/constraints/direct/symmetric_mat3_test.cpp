// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/symmetric_mat3.h"

#include <gtest/gtest.h>

#include "jostle/physics/quat.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(SymmetricMat3, rotated_diagonal_maps_the_axes_to_their_multiples) {
    const Mat3 axes = to_matrix(from_rotation_vector({0.3, -0.5, 0.7}));
    const SymmetricMat3 m = symmetric_in_axes(axes, {1, 2, 3});
    EXPECT_LT(length(m * axes.x - axes.x), 1e-15);
    EXPECT_LT(length(m * axes.y - axes.y * 2), 1e-15);
    EXPECT_LT(length(to_mat3(m) * axes.z - axes.z * 3), 1e-15);
}

TEST(SymmetricMat3, inverts_positive_definite_matrices_only) {
    const Mat3 axes = to_matrix(from_rotation_vector({0.3, -0.5, 0.7}));
    const Vec3 v{1, -2, 0.5};
    SymmetricMat3 inverse;
    ASSERT_TRUE(invert(symmetric_in_axes(axes, {1, 2, 3}), inverse));
    EXPECT_LT(length(inverse * (symmetric_in_axes(axes, {1, 2, 3}) * v) - v), 1e-14);
    EXPECT_FALSE(invert(symmetric_in_axes(axes, {1, -2, 3}), inverse));
    EXPECT_FALSE(invert(symmetric_in_axes(axes, {-1, -2, 3}), inverse));
    EXPECT_FALSE(invert({}, inverse));
}

}  // namespace
}  // namespace jostle::test
