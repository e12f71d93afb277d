// SPDX-License-Identifier: MIT
//
// Where a point is, against the sum of the angles under which it sees the sides.
#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/polygon.h"
#include "tests/support/grid_oracle.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

// For points that are not on a side.
int turns_by_angles(std::span<const GridPoint2> polygon, GridPoint2 p) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); k++) {
        const GridPoint2 a = polygon[k] - p, b = polygon[(k + 1) % polygon.size()] - p;
        sum += std::atan2(static_cast<double>(cross(a, b)), static_cast<double>(dot(a, b)));
    }
    return static_cast<int>(std::lround(sum / (2 * pi)));
}

// The number of sides that a ray crosses is odd where the polygon runs round an odd number of
// times.
void compare(std::span<const GridPoint2> polygon, GridPoint2 p) {
    const std::vector<Vec2> corners = real(polygon);
    bool boundary = false;
    for (std::size_t k = 0; k < polygon.size(); k++)
        boundary = boundary || lies_on(polygon[k], polygon[(k + 1) % polygon.size()], p);
    const Location by_crossings = locate_by_crossings(corners, p.real()),
                   by_winding = locate_by_winding(corners, p.real());
    if (boundary) {
        ASSERT_EQ(by_crossings, Location::boundary);
        ASSERT_EQ(by_winding, Location::boundary);
        return;
    }
    const int turns = turns_by_angles(polygon, p);
    ASSERT_EQ(winding_number(corners, p.real()), turns);
    ASSERT_EQ(by_winding, turns != 0 ? Location::inside : Location::outside);
    ASSERT_EQ(by_crossings, turns % 2 != 0 ? Location::inside : Location::outside);
}

// Every place of a small grid: rays through corners and along sides are the rule there.
TEST(PointInPolygon, matches_the_angle_sum_on_any_closed_polyline) {
    Random random(11);
    for (int round = 0; round < 3000; round++) {
        std::vector<GridPoint2> polygon;
        for (std::size_t k = 0, n = 1 + random.below(9); k < n; k++)
            polygon.push_back(random_point(random, 6));
        for (std::int64_t x = -1; x < 7; x++)
            for (std::int64_t y = -1; y < 7; y++) compare(polygon, {x, y});
    }
}

TEST(PointInPolygon, both_methods_match_the_angle_sum_on_simple_polygons) {
    Random random(12);
    for (int round = 0; round < 500; round++) {
        const auto polygon = random_polygon(random, 24, 12);
        const auto corners = real(polygon);
        for (std::int64_t x = -1; x < 13; x++)
            for (std::int64_t y = -1; y < 13; y++) {
                const GridPoint2 p{x, y};
                compare(polygon, p);
                ASSERT_EQ(locate_by_crossings(corners, p.real()),
                          locate_by_winding(corners, p.real()));
            }
    }
}

TEST(PointInPolygon, crossing_and_winding_rules_differ_inside_a_pentagram) {
    const std::vector<Vec2> star{{0, 10}, {6, -8}, {-9, 3}, {9, 3}, {-6, -8}};
    EXPECT_EQ(winding_number(star, {0, 0}), -2);
    EXPECT_EQ(locate_by_crossings(star, {0, 0}), Location::outside);
    EXPECT_EQ(locate_by_winding(star, {0, 0}), Location::inside);
    EXPECT_EQ(locate_by_crossings(star, {0, 8}), Location::inside) << "in a point of the star";
}

TEST(PointInPolygon, is_exact_one_ulp_from_a_side) {
    const std::vector<Vec2> triangle{{0, 0}, {1, 1}, {0, 1}};
    const double x = 0.1, up = std::nextafter(x, 1), down = std::nextafter(x, 0);
    for (const auto locate : {locate_by_crossings, locate_by_winding}) {
        EXPECT_EQ(locate(triangle, {x, x}), Location::boundary);
        EXPECT_EQ(locate(triangle, {x, up}), Location::inside);
        EXPECT_EQ(locate(triangle, {x, down}), Location::outside);
        EXPECT_EQ(locate({}, {x, x}), Location::outside) << "no corners";
        EXPECT_EQ(locate(std::vector<Vec2>{{x, x}}, {x, x}), Location::boundary) << "a point";
    }
}

}  // namespace
}  // namespace jostle::test
