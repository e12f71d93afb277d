// SPDX-License-Identifier: MIT
#include "physics/src/math/is_unit.h"

#include <gtest/gtest.h>

#include <limits>

namespace jostle::test {
namespace {
using namespace physics;

TEST(IsUnit, accepts_unit_vectors_within_the_tolerance) {
    EXPECT_TRUE(is_unit({0, -1, 0}));
    EXPECT_TRUE(is_unit({0.6, 0, 0.8}));
    EXPECT_TRUE(is_unit({1 + 4e-7, 0, 0}));
    EXPECT_FALSE(is_unit({1 + 6e-7, 0, 0}));
    EXPECT_TRUE(is_unit({1 + 6e-7, 0, 0}, 1e-5));
}

TEST(IsUnit, rejects_zero_and_passes_nan) {
    EXPECT_FALSE(is_unit({}));
    EXPECT_TRUE(is_unit({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
}

}  // namespace
}  // namespace jostle::test
