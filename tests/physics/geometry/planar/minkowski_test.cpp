// SPDX-License-Identifier: MIT
//
// Sums and differences by their support in every direction of a grid, in integers; distances by a
// search over directions.
#include <gtest/gtest.h>

#include "jostle/physics/planar.h"
#include "tests/support/grid_oracle.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

std::vector<GridPoint2> random_set(Random& random, std::uint64_t side) {
    std::vector<GridPoint2> points;
    for (std::size_t k = 0, n = 1 + random.below(8); k < n; k++)
        points.push_back(random_point(random, side));
    return points;
}

std::int64_t support(std::span<const GridPoint2> points, GridPoint2 way) {
    std::int64_t most = INT64_MIN;
    for (const GridPoint2 p : points) most = std::max(most, dot(p, way));
    return most;
}

// Sets with the same support in every direction in which either has a side are the same.
TEST(Minkowski, support_of_sum_equals_sum_of_supports) {
    Random random(51);
    for (int round = 0; round < 3000; round++) {
        const auto a = random_set(random, 7), b = random_set(random, 7);
        const auto sum = must(minkowski_sum(real(a), real(b))),
                   difference = must(minkowski_difference(real(a), real(b)));
        std::vector<GridPoint2> plus, minus;
        for (const Vec2 p : sum) plus.push_back(grid(p));
        for (const Vec2 p : difference) minus.push_back(grid(p));
        for (std::int64_t x = -7; x <= 7; x++)
            for (std::int64_t y = -7; y <= 7; y++) {
                const GridPoint2 way{x, y}, back{-x, -y};
                ASSERT_EQ(support(plus, way), support(a, way) + support(b, way));
                ASSERT_EQ(support(minus, way), support(a, way) + support(b, back));
            }
        const std::size_t n = plus.size();
        for (std::size_t k = 0; k < n && n > 2; k++)
            ASSERT_GT(cross(plus[(k + 1) % n] - plus[k], plus[(k + 2) % n] - plus[(k + 1) % n]), 0)
                << "a corner that is none";
    }
}

TEST(Minkowski, sum_of_square_and_triangle_is_exact) {
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        triangle{{0, 0}, {2, 0}, {0, 2}};
    EXPECT_EQ(must(minkowski_sum(square, triangle)),
              (std::vector<Vec2>{{0, 0}, {3, 0}, {3, 1}, {1, 3}, {0, 3}}));
    EXPECT_FALSE(minkowski_sum(square, {}).ok());
    EXPECT_FALSE(separation({}, square).ok());
}

// The gap that a direction leaves between the two sets is never more than the signed distance.
double gap(const std::vector<Vec2>& a, const std::vector<Vec2>& b, Vec2 way) {
    double end = -1e300, start = 1e300;
    for (const Vec2 p : a) end = maximum(end, dot(p, way));
    for (const Vec2 p : b) start = minimum(start, dot(p, way));
    return start - end;
}

// It is the largest gap: its own direction leaves it, and none of 720 leaves more.
TEST(Separation, is_the_largest_gap_over_all_directions) {
    Random random(52);
    int apart = 0, deep = 0;
    for (int round = 0; round < 3000; round++) {
        const auto a = real(random_set(random, 9));
        auto b = real(random_set(random, 9));
        const Vec2 away{random.in(-6, 6), random.in(-6, 6)};
        if (round % 3 != 0)
            for (Vec2& p : b) p = p + away;
        const Separation found = must(separation(a, b));
        ASSERT_NEAR(length(found.direction), 1, 1e-14);
        if (absolute(found.distance) > 1e-12) {
            ASSERT_NEAR(gap(a, b, found.direction), found.distance, 1e-12) << "round " << round;
        }
        for (int k = 0; k < 720; k++) {
            const SinCos way = sin_cos(k * (pi / 360));
            ASSERT_LE(gap(a, b, {way.cos, way.sin}), found.distance + 1e-12);
        }
        apart += found.distance > 0 ? 1 : 0;
        deep += found.distance < 0 ? 1 : 0;
        // Seen from the other.
        ASSERT_NEAR(must(separation(b, a)).distance, found.distance, 1e-12);
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(deep, 500);
}

TEST(Separation, matches_known_pairs) {
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto moved = [&](Vec2 by) {
        std::vector<Vec2> out = square;
        for (Vec2& p : out) p = p + by;
        return out;
    };
    EXPECT_EQ(must(separation(square, moved({3, 0}))).distance, 2);
    EXPECT_EQ(must(separation(square, moved({3, 0}))).direction, (Vec2{1, 0}));
    EXPECT_EQ(must(separation(square, moved({4, 5}))).distance, 5);
    EXPECT_EQ(must(separation(square, moved({0.75, 0.25}))).distance, -0.25);
    EXPECT_EQ(must(separation(square, moved({0.75, 0.25}))).direction, (Vec2{1, 0}));
    EXPECT_EQ(must(separation(square, moved({1, 0}))).distance, 0) << "they touch";
    const std::vector<Vec2> point{{0.5, 0.5}};
    EXPECT_EQ(must(separation(square, point)).distance, -0.5);
    EXPECT_EQ(must(separation(point, point)).distance, 0);
}

}  // namespace
}  // namespace jostle::test
