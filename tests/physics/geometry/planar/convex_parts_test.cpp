// SPDX-License-Identifier: MIT
//
// Convex parts: each is convex in integers, together they have the polygon's area and sides, and
// they are as few as Hertel and Mehlhorn promise.
#include <gtest/gtest.h>

#include <map>

#include "jostle/physics/polygon.h"
#include "tests/support/grid_oracle.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

std::size_t hollow_corners(const std::vector<GridPoint2>& polygon) {
    const std::size_t n = polygon.size();
    const std::int64_t sign = twice_area(polygon) > 0 ? 1 : -1;
    std::size_t count = 0;
    for (std::size_t k = 0; k < n; k++)
        count += sign * cross(polygon[(k + 1) % n] - polygon[k],
                              polygon[(k + 2) % n] - polygon[(k + 1) % n]) <
                         0
                     ? 1
                     : 0;
    return count;
}

void expect_fill(const std::vector<GridPoint2>& polygon, const std::vector<ConvexPart>& parts) {
    std::int64_t area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const ConvexPart& part : parts) {
        const std::size_t m = part.size();
        ASSERT_GE(m, 3u);
        std::vector<GridPoint2> corners;
        for (const std::uint32_t k : part) corners.push_back(polygon.at(k));
        for (std::size_t k = 0; k < m; k++) {
            ASSERT_GE(cross(corners[(k + 1) % m] - corners[k],
                            corners[(k + 2) % m] - corners[(k + 1) % m]),
                      0);
            sides[{part[k], part[(k + 1) % m]}]++;
        }
        const std::int64_t own = twice_area(corners);
        ASSERT_GT(own, 0);
        area += own;
    }
    ASSERT_EQ(area, std::abs(twice_area(polygon)));
    // Those that are not shared by two are the polygon's own.
    std::size_t border = 0;
    for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 1);
        border += sides.count({side.second, side.first}) == 0 ? 1 : 0;
    }
    ASSERT_EQ(border, polygon.size());
}

// Each diagonal that stays belongs to a corner that is not convex, and no such corner needs more
// than two: at most 2 r + 1 parts.
TEST(ConvexParts, fill_random_polygons_and_are_few) {
    Random random(81);
    for (int round = 0; round < 4000; round++) {
        const auto polygon = random_polygon(random, 3 + random.below(30), 4 + random.below(20));
        const auto parts = must(convex_parts(real(polygon)));
        expect_fill(polygon, parts);
        ASSERT_LE(parts.size(), 2 * hollow_corners(polygon) + 1);
    }
}

TEST(ConvexParts, respect_the_corner_limit) {
    Random random(82);
    for (int round = 0; round < 1000; round++) {
        const auto polygon = random_polygon(random, 30, 16);
        const std::size_t most = 3 + random.below(4);
        const auto parts = must(convex_parts(real(polygon), most));
        expect_fill(polygon, parts);
        for (const ConvexPart& part : parts) ASSERT_LE(part.size(), most);
        if (most == 3) {
            ASSERT_EQ(parts.size(), polygon.size() - 2);
        }
    }
    EXPECT_FALSE(convex_parts(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}, 2).ok());
}

// A point of the polygon that is on no side of a part is in exactly one of them.
TEST(ConvexParts, cover_each_point_once) {
    Random random(83);
    for (int round = 0; round < 200; round++) {
        const auto polygon = real(random_polygon(random, 20, 10));
        const auto parts = must(convex_parts(polygon));
        for (int k = 0; k < 50; k++) {
            const Vec2 p{random.in(-1, 11), random.in(-1, 11)};
            int held = 0;
            for (const ConvexPart& part : parts) {
                std::vector<Vec2> corners;
                for (const std::uint32_t corner : part) corners.push_back(polygon[corner]);
                held += locate_by_winding(corners, p) == Location::inside ? 1 : 0;
            }
            ASSERT_EQ(held, locate_by_crossings(polygon, p) == Location::inside ? 1 : 0);
        }
    }
}

TEST(ConvexParts, match_known_polygons) {
    const auto count = [](const std::vector<Vec2>& polygon) {
        return must(convex_parts(polygon)).size();
    };
    EXPECT_EQ(count({{0, 0}, {4, 0}, {6, 3}, {2, 5}, {-1, 2}}), 1u) << "convex";
    EXPECT_EQ(count({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}), 1u) << "with a straight corner";
    EXPECT_EQ(count({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}), 2u) << "an L";
    EXPECT_LE(count({{1, 0},
                     {2, 0},
                     {2, 1},
                     {3, 1},
                     {3, 2},
                     {2, 2},
                     {2, 3},
                     {1, 3},
                     {1, 2},
                     {0, 2},
                     {0, 1},
                     {1, 1}}),
              5u)
        << "a cross: three at best";
}

}  // namespace
}  // namespace jostle::test
