// SPDX-License-Identifier: MIT
#include "physics/src/math/principal_axes.h"

#include <gtest/gtest.h>

#include <random>

#include "physics/src/constraints/direct/direct_body.h"

namespace jostle::test {
namespace {
using namespace physics;

double largest(const Mat3& m) {
    const Vec3 most = max(abs(m.x), max(abs(m.y), abs(m.z)));
    return maximum(most.x, maximum(most.y, most.z));
}

// Put together again they are the tensor, thin bodies and near spheres alike.
TEST(PrincipalAxes, recompose_any_tensor) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 1000; k++) {
        const Quat turn = normalized(Quat{any(random), any(random), any(random), any(random)});
        const Vec3 moments = k % 3 == 0   ? Vec3{1, 1 + 1e-9 * any(random), 1}
                             : k % 3 == 1 ? Vec3{1e-6, 1, 1}
                                          : Vec3{1, 2 + any(random), 1.5};
        const Mat3 tensor = in_axes(to_matrix(turn), moments);
        const PrincipalAxes axes = principal_axes(tensor);
        EXPECT_LT(largest(in_axes(to_matrix(axes.frame), axes.moments) - tensor), 1e-14);
    }
}

TEST(PrincipalAxes, keep_the_axes_of_a_diagonal_tensor) {
    EXPECT_EQ(principal_axes(diagonal({3, 1, 2})), (PrincipalAxes{{}, {3, 1, 2}}));
}

}  // namespace
}  // namespace jostle::test
