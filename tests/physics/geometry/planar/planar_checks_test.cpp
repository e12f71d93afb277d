// SPDX-License-Identifier: MIT
#include "physics/src/geometry/planar/planar_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/support/error_of.h"

namespace jostle::test {
namespace {
using namespace physics;
using physics::planar::check_points;
using testing::HasSubstr;

TEST(PlanarChecks, accept_finite_points_within_limits) {
    EXPECT_TRUE(check_points("points", std::vector<Vec2>{{1e7, -1e7}}, 1, 1).ok());
}

TEST(PlanarChecks, errors_name_the_list_and_the_point) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THAT(error_of(check_points("a", std::vector<Vec2>{{0, 0}}, 2, 5)).message,
                HasSubstr("a has 1 points; it must have from 2 to 5"));
    EXPECT_FALSE(check_points("a", std::vector<Vec2>(6), 2, 5).ok());
    for (const Vec2 bad : {Vec2{nan, 0}, Vec2{0, nan}, Vec2{infinity, 0}, Vec2{0, -1.1e7}}) {
        const std::vector<Vec2> points{{0, 0}, {1, 1}, bad};
        EXPECT_THAT(error_of(check_points("points", points, 1, 5)).message,
                    HasSubstr("points[2] is ("));
    }
}

}  // namespace
}  // namespace jostle::test
