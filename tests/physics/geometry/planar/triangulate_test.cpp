// SPDX-License-Identifier: MIT
//
// Triangles that fill a polygon: their areas add up to its area in integers, each of its sides is
// the side of one, and all others are shared by two that lie on both sides of it.
#include <gtest/gtest.h>

#include <map>

#include "jostle/physics/polygon.h"
#include "tests/support/grid_oracle.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

void expect_fills(const std::vector<GridPoint2>& polygon, const std::vector<Triangle>& triangles) {
    const std::size_t n = polygon.size();
    ASSERT_EQ(triangles.size(), n - 2);
    std::int64_t area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : triangles) {
        for (const std::uint32_t k : t) ASSERT_LT(k, n);
        const std::int64_t own =
            cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]);
        ASSERT_GT(own, 0);
        area += own;
        for (std::size_t k = 0; k < 3; k++) sides[{t[k], t[(k + 1) % 3]}]++;
    }
    const std::int64_t whole = twice_area(polygon);
    ASSERT_EQ(area, std::abs(whole));
    for (std::uint32_t k = 0; k < n; k++) {
        const auto after = static_cast<std::uint32_t>((k + 1) % n);
        const auto side = whole > 0 ? std::pair(k, after) : std::pair(after, k);
        ASSERT_EQ(sides[side], 1);
        sides.erase(side);
    }
    for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
}

TEST(Triangulate, fills_random_polygons) {
    Random random(71);
    for (int round = 0; round < 4000; round++) {
        const std::uint64_t side = 4 + random.below(20);
        const auto polygon = random_polygon(random, 3 + random.below(30), side);
        expect_fills(polygon, must(triangulate(real(polygon))));
    }
}

TEST(Triangulate, fills_mostly_collinear_polygons) {
    // A square with three corners of 180 degrees on each side, and a triangle with one on one.
    const std::vector<GridPoint2> square{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1},
                                         {4, 2}, {4, 3}, {4, 4}, {3, 4}, {2, 4}, {1, 4},
                                         {0, 4}, {0, 3}, {0, 2}, {0, 1}};
    expect_fills(square, must(triangulate(real(square))));
    const std::vector<GridPoint2> triangle{{0, 0}, {2, 0}, {4, 0}, {0, 3}};
    expect_fills(triangle, must(triangulate(real(triangle))));
}

// A comb of 1024 teeth, and a spiral: half of the corners are not convex.
TEST(Triangulate, fills_combs_and_spirals) {
    std::vector<GridPoint2> comb{{0, -1}, {4096, -1}};
    for (std::int64_t tooth = 1023; tooth >= 0; tooth--) {
        comb.push_back({4 * tooth + 3, 50});
        comb.push_back({4 * tooth + 1, tooth % 7});
    }
    expect_fills(comb, must(triangulate(real(comb))));
    std::vector<GridPoint2> outer, inner;
    GridPoint2 at{}, way{1, 0};
    for (std::int64_t k = 0; k < 200; k++) {
        const GridPoint2 left{-way.y, way.x};
        outer.push_back(at);
        inner.push_back(at + left + way);
        at = at + GridPoint2{way.x * (4 * (k / 2) + 8), way.y * (4 * (k / 2) + 8)};
        way = left;
    }
    outer[0] = outer[0] - GridPoint2{1, 0};
    std::reverse(inner.begin(), inner.end());
    outer.insert(outer.end(), inner.begin(), inner.end());
    if (is_simple(outer)) expect_fills(outer, must(triangulate(real(outer))));
    EXPECT_TRUE(is_simple(outer)) << "the test's own polygon";
}

TEST(Triangulate, rejects_non_simple_polygons) {
    EXPECT_FALSE(triangulate(std::vector<Vec2>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}).ok());
    EXPECT_FALSE(triangulate(std::vector<Vec2>{{0, 0}, {1, 0}}).ok());
}

// Numbers so small that their products are none: an error or triangles, and an end in any case.
TEST(Triangulate, terminates_on_denormal_coordinates) {
    Random random(72);
    for (int round = 0; round < 500; round++) {
        std::vector<Vec2> polygon;
        for (const GridPoint2 p : random_polygon(random, 12, 6))
            polygon.push_back(p.real() * 1e-170);
        const auto triangles = triangulate(polygon);
        if (triangles.ok()) {
            EXPECT_EQ(triangles->size(), polygon.size() - 2);
        }
    }
}

}  // namespace
}  // namespace jostle::test
