// SPDX-License-Identifier: MIT
//
// Hulls by both methods, against a test of each point by itself: a corner is what no triangle and
// no segment of the others holds.
#include "physics/src/geometry/planar/planar_checks.h"

#include <gtest/gtest.h>

#include "jostle/physics/planar.h"
#include "tests/support/grid_oracle.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

bool in_triangle(GridPoint2 a, GridPoint2 b, GridPoint2 c, GridPoint2 p) {
    const std::int64_t u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
    if (cross(b - a, c - a) == 0) return lies_on(a, b, p) || lies_on(b, c, p) || lies_on(a, c, p);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

std::set<GridPoint2> corners_of(const std::set<GridPoint2>& points) {
    std::set<GridPoint2> out;
    for (const GridPoint2 p : points) {
        std::vector<GridPoint2> others;
        for (const GridPoint2 q : points)
            if (q != p) others.push_back(q);
        bool held = false;
        for (const GridPoint2 a : others)
            for (const GridPoint2 b : others)
                for (const GridPoint2 c : others) held = held || in_triangle(a, b, c, p);
        if (!held) out.insert(p);
    }
    return out;
}

void compare(const std::vector<GridPoint2>& points) {
    const auto chain = must(convex_hull(real(points)));
    ASSERT_EQ(chain, must(hull_by_gift_wrapping(real(points))));
    ASSERT_EQ(chain, hull_of_checked(real(points)));
    std::vector<GridPoint2> corners;
    for (const Vec2 p : chain) corners.push_back(grid(p));
    const std::set<GridPoint2> given(points.begin(), points.end());
    ASSERT_EQ(std::set<GridPoint2>(corners.begin(), corners.end()), corners_of(given));
    ASSERT_EQ(corners[0], *given.begin()) << "the leftmost, of those the lowest";
    if (corners.size() < 3) return;
    for (std::size_t k = 0; k < corners.size(); k++) {
        const GridPoint2 a = corners[k], b = corners[(k + 1) % corners.size()];
        for (const GridPoint2 p : points) ASSERT_GE(cross(b - a, p - a), 0);
    }
}

TEST(PlanarHull, matches_brute_force_on_small_grids) {
    Random random(21);
    for (int round = 0; round < 3000; round++) {
        std::vector<GridPoint2> points;
        const std::uint64_t side = 1 + random.below(7);
        for (std::size_t k = 0, n = 1 + random.below(9); k < n; k++)
            points.push_back(random_point(random, side));
        compare(points);
    }
}

TEST(PlanarHull, handles_degenerate_sets) {
    for (const auto method : {convex_hull, hull_by_gift_wrapping}) {
        EXPECT_EQ(must(method(std::vector<Vec2>{{2, 1}})), (std::vector<Vec2>{{2, 1}}));
        EXPECT_EQ(must(method(std::vector<Vec2>(5, Vec2{2, 1}))), (std::vector<Vec2>{{2, 1}}));
        EXPECT_EQ(must(method(std::vector<Vec2>{{2, 2}, {0, 0}, {1, 1}, {2, 2}})),
                  (std::vector<Vec2>{{0, 0}, {2, 2}}));
        EXPECT_EQ(must(method(std::vector<Vec2>{{1, 1}, {0, 1}, {1, 0}, {0, 0}, {0.5, 0}})),
                  (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
        EXPECT_FALSE(method(std::vector<Vec2>{}).ok());
        EXPECT_FALSE(method(std::vector<Vec2>{{0, 1e8}}).ok());
    }
}

// Points that are on one line but for rounding: every other method than an exact one may lose a
// corner or end in a loop.
TEST(PlanarHull, both_methods_agree_on_nearly_collinear_points) {
    Random random(22);
    for (int round = 0; round < 300; round++) {
        std::vector<Vec2> points;
        const Vec2 way{random.in(-1, 1), random.in(-1, 1)},
            from{random.in(-9, 9), random.in(-9, 9)};
        for (int k = 0; k < 200; k++) points.push_back(from + way * random.in(0, 1));
        const auto hull = must(convex_hull(points));
        ASSERT_EQ(hull, must(hull_by_gift_wrapping(points)));
        for (std::size_t k = 0; k < hull.size() && hull.size() > 2; k++)
            for (const Vec2 p : points)
                ASSERT_GE(orientation(hull[k], hull[(k + 1) % hull.size()], p), 0);
    }
}

TEST(PlanarHull, both_methods_agree_on_many_points) {
    Random random(23);
    std::vector<Vec2> points;
    for (int k = 0; k < 20000; k++) points.push_back({random.in(-1, 1), random.in(-1, 1)});
    EXPECT_EQ(must(convex_hull(points)), must(hull_by_gift_wrapping(points)));
}

}  // namespace
}  // namespace jostle::test
