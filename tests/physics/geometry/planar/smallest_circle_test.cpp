// SPDX-License-Identifier: MIT
//
// The smallest circle against a search over all circles that two or three of the points define.
#include <gtest/gtest.h>

#include "jostle/physics/planar.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

double reach(const std::vector<Vec2>& points, Vec2 center) {
    double most = 0;
    for (const Vec2 p : points) most = maximum(most, length(p - center));
    return most;
}

// The smallest reach over the midpoints of all pairs and the circumcentres of all triples: one of
// them is the centre.
double radius_by_search(const std::vector<Vec2>& points) {
    double least = points.size() == 1 ? 0 : 1e300;
    for (const Vec2 a : points)
        for (const Vec2 b : points) {
            least = minimum(least, reach(points, (a + b) * 0.5));
            for (const Vec2 c : points) {
                // |x - a| = |x - b| = |x - c|, by Cramer's rule.
                const Vec2 u = b - a, v = c - a;
                const double det = 2 * cross(u, v);
                if (absolute(det) < 1e-9) continue;
                const double p = dot(b, b) - dot(a, a), q = dot(c, c) - dot(a, a);
                least = minimum(
                    least, reach(points, {(p * v.y - q * u.y) / det, (u.x * q - v.x * p) / det}));
            }
        }
    return least;
}

TEST(SmallestCircle, is_minimal_over_all_pairs_and_triples) {
    Random random(31);
    for (int round = 0; round < 2000; round++) {
        std::vector<Vec2> points;
        const bool on_grid = round % 2 == 0;  // many on one circle, in one line, equal
        for (std::size_t k = 0, n = 1 + random.below(9); k < n; k++)
            points.push_back(on_grid ? Vec2{static_cast<double>(random.below(5)),
                                            static_cast<double>(random.below(5))}
                                     : Vec2{random.in(-1, 1), random.in(-1, 1)});
        const Circle circle = must(smallest_circle(points));
        ASSERT_NEAR(circle.radius, radius_by_search(points), 1e-12) << "round " << round;
        ASSERT_LE(reach(points, circle.center), circle.radius);
    }
}

TEST(SmallestCircle, matches_known_sets) {
    EXPECT_EQ(must(smallest_circle(std::vector<Vec2>(3, Vec2{4, 5}))).radius, 0);
    const Circle line = must(smallest_circle(std::vector<Vec2>{{0, 0}, {1, 0}, {4, 0}, {2, 0}}));
    EXPECT_EQ(line.center, (Vec2{2, 0}));
    EXPECT_EQ(line.radius, 2);
    const Circle obtuse = must(smallest_circle(std::vector<Vec2>{{0, 0}, {4, 0}, {2, 0.5}}));
    EXPECT_EQ(obtuse.radius, 2) << "the longest side is its diameter";
    const Circle square = must(smallest_circle(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
    EXPECT_NEAR(square.radius, square_root(2), 1e-15);
    EXPECT_FALSE(smallest_circle(std::vector<Vec2>{}).ok());
}

// All of them are on it, but for rounding: the hardest case for a test of which are inside.
TEST(SmallestCircle, recovers_a_circle_of_a_hundred_thousand_points) {
    for (const Vec2 center : {Vec2{}, Vec2{1e6, -1e6}}) {
        std::vector<Vec2> points;
        for (int k = 0; k < 100000; k++) {
            const SinCos a = sin_cos(k * (2 * pi / 100000));
            points.push_back(center + Vec2{a.cos, a.sin} * 3);
        }
        const Circle circle = must(smallest_circle(points));
        EXPECT_NEAR(circle.radius, 3, 1e-9);
        EXPECT_LE(length(circle.center - center), 1e-9);
        EXPECT_LE(reach(points, circle.center), circle.radius);
    }
}

// The order of the points changes nothing but the last bits.
TEST(SmallestCircle, is_independent_of_the_point_order) {
    Random random(32);
    std::vector<Vec2> points;
    for (int k = 0; k < 1000; k++) points.push_back({random.in(-1, 1), random.in(-1, 1)});
    const Circle one = must(smallest_circle(points));
    std::reverse(points.begin(), points.end());
    const Circle other = must(smallest_circle(points));
    EXPECT_EQ(one.center, other.center);
    EXPECT_EQ(one.radius, other.radius);
}

}  // namespace
}  // namespace jostle::test
