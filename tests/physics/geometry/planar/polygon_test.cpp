// SPDX-License-Identifier: MIT
//
// Which polygons are simple, which way round they run, and their areas.
#include "physics/src/geometry/planar/planar_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/grid_oracle.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;
using testing::HasSubstr;

TEST(Polygon, accepts_exactly_the_simple_polygons) {
    Random random(61);
    int simple = 0;
    for (int round = 0; round < 100000; round++) {
        std::vector<GridPoint2> polygon;
        for (std::size_t k = 0, n = 3 + random.below(5); k < n; k++)
            polygon.push_back(random_point(random, 4));
        const bool expected = is_simple(polygon);
        ASSERT_EQ(check_polygon(real(polygon)).ok(), expected);
        simple += expected ? 1 : 0;
    }
    EXPECT_GT(simple, 5000);
}

TEST(Polygon, area_and_orientation_match_integer_arithmetic) {
    Random random(62);
    for (int round = 0; round < 2000; round++) {
        const auto polygon = random_polygon(random, 20, 10);
        ASSERT_EQ(2 * signed_area(real(polygon)), static_cast<double>(twice_area(polygon)));
        ASSERT_EQ(runs_counter_clockwise(real(polygon)), twice_area(polygon) > 0);
        ASSERT_TRUE(check_polygon(real(polygon)).ok());
    }
    EXPECT_EQ(signed_area({}), 0);
}

TEST(Polygon, errors_name_the_offending_corners) {
    const auto fault = [](const std::vector<Vec2>& polygon) {
        return error_of(check_polygon(polygon)).message;
    };
    EXPECT_THAT(fault({{0, 0}, {1, 0}}),
                HasSubstr("polygon has 2 points; it must have from 3 to 4096"));
    EXPECT_THAT(fault({{0, 0}, {1, 0}, {0, 1e9}}), HasSubstr("polygon[2] is (0, 1e+09)"));
    EXPECT_THAT(fault({{0, 0}, {1, 0}, {1, 1}, {0, 0}}), HasSubstr("corners 3 and 0 are equal"));
    EXPECT_THAT(fault({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), HasSubstr("sides 0 and 2 intersect"));
    EXPECT_THAT(fault({{0, 0}, {2, 0}, {1, 0}, {1, 1}}),
                HasSubstr("sides 0 and 1 double back on each other"));
    EXPECT_THAT(fault({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}),
                HasSubstr("sides 0 and 3 intersect"))
        << "corner 3 is on side 0";
    EXPECT_THAT(fault(std::vector<Vec2>(4097)), HasSubstr("has 4097 points"));
}

}  // namespace
}  // namespace jostle::test
