// SPDX-License-Identifier: MIT
//
// Boxes against a search over directions.
#include <gtest/gtest.h>

#include "jostle/physics/planar.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

std::vector<Vec2> random_points(Random& random) {
    std::vector<Vec2> points;
    const bool on_grid = random.below(3) == 0;
    for (std::size_t k = 0, n = 1 + random.below(12); k < n; k++)
        points.push_back(on_grid ? Vec2{static_cast<double>(random.below(4)),
                                        static_cast<double>(random.below(4))}
                                 : Vec2{random.in(-2, 2), random.in(-1, 1)});
    return points;
}

// The area of the box along a direction that is not of unit length.
double area_along(const std::vector<Vec2>& points, Vec2 way) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (const Vec2 p : points) {
        const double at[2] = {dot(p, way), cross(way, p)};
        for (int k = 0; k < 2; k++) {
            low[k] = minimum(low[k], at[k]);
            high[k] = maximum(high[k], at[k]);
        }
    }
    return (high[0] - low[0]) * (high[1] - low[1]) / length_squared(way);
}

void expect_holds(const OrientedBox& box, const std::vector<Vec2>& points) {
    EXPECT_NEAR(length(box.axis), 1, 1e-15);
    EXPECT_TRUE(box.axis.x > 0 || (box.axis.x == 0 && box.axis.y == 1));
    for (const Vec2 p : points) {
        const Vec2 from = p - box.center;
        EXPECT_LE(absolute(dot(from, box.axis)), box.half_length + 1e-14);
        EXPECT_LE(absolute(cross(box.axis, from)), box.half_width + 1e-14);
    }
}

// Over the directions of all pairs of points, among which are the hull's sides, and over 3600
// directions all round.
TEST(SmallestBox, is_minimal_over_all_directions) {
    Random random(41);
    for (int round = 0; round < 2000; round++) {
        const auto points = random_points(random);
        const OrientedBox box = must(smallest_box(points));
        expect_holds(box, points);
        ASSERT_GE(box.half_length, box.half_width);
        double best = 1e300;
        for (const Vec2 a : points)
            for (const Vec2 b : points)
                if (a != b) best = minimum(best, area_along(points, b - a));
        if (best == 1e300) best = 0;
        const double area = 4 * box.half_length * box.half_width;
        ASSERT_NEAR(area, best, 1e-12) << "round " << round;
        for (int k = 0; k < 3600 && round % 10 == 0; k++) {
            const SinCos way = sin_cos(k * (pi / 3600));
            ASSERT_LE(area, area_along(points, {way.cos, way.sin}) + 1e-12);
        }
    }
}

TEST(SmallestBox, matches_known_sets) {
    const OrientedBox point = must(smallest_box(std::vector<Vec2>(2, Vec2{4, 5})));
    EXPECT_EQ(point.center, (Vec2{4, 5}));
    EXPECT_EQ(point.half_length, 0);
    const OrientedBox line = must(smallest_box(std::vector<Vec2>{{0, 0}, {3, 4}}));
    EXPECT_NEAR(line.half_length, 2.5, 1e-15);
    EXPECT_NEAR(line.half_width, 0, 1e-15);
    EXPECT_LE(length(line.axis - Vec2{0.6, 0.8}), 1e-15);
    // A rectangle of 4 by 2, turned.
    std::vector<Vec2> turned;
    const SinCos a = sin_cos(0.3);
    for (const Vec2 p : {Vec2{2, 1}, Vec2{-2, 1}, Vec2{-2, -1}, Vec2{2, -1}})
        turned.push_back(Vec2{7, 8} + Vec2{p.x * a.cos - p.y * a.sin, p.x * a.sin + p.y * a.cos});
    const OrientedBox box = must(smallest_box(turned));
    EXPECT_NEAR(box.half_length, 2, 1e-14);
    EXPECT_NEAR(box.half_width, 1, 1e-14);
    EXPECT_LE(length(box.center - Vec2{7, 8}), 1e-14);
    EXPECT_LE(length(box.axis - Vec2{a.cos, a.sin}), 1e-14);
}

// The points are spread most along one of its axes: no direction beats it.
TEST(PcaBox, is_aligned_with_the_largest_variance) {
    Random random(42);
    for (int round = 0; round < 500; round++) {
        const auto points = random_points(random);
        const OrientedBox box = must(pca_box(points));
        expect_holds(box, points);
        const auto spread = [&](Vec2 axis) {
            double sum = 0, squares = 0;
            for (const Vec2 p : points) {
                sum += dot(p, axis);
                squares += dot(p, axis) * dot(p, axis);
            }
            return squares - sum * sum / static_cast<double>(points.size());
        };
        const double most = maximum(spread(box.axis), spread({-box.axis.y, box.axis.x}));
        for (int k = 0; k < 360; k++) {
            const SinCos way = sin_cos(k * (pi / 360));
            ASSERT_LE(spread({way.cos, way.sin}), most + 1e-12);
        }
    }
}

TEST(PcaBox, falls_back_to_x_without_a_principal_axis) {
    EXPECT_EQ(must(pca_box(std::vector<Vec2>(4, Vec2{1, 2}))).axis, (Vec2{1, 0}));
    const OrientedBox square = must(pca_box(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
    EXPECT_EQ(square.axis, (Vec2{1, 0}));
    EXPECT_EQ(square.center, (Vec2{1, 1}));
    EXPECT_EQ(square.half_width, 1);
    const OrientedBox upright = must(pca_box(std::vector<Vec2>{{1, 0}, {1, 5}}));
    EXPECT_EQ(upright.axis, (Vec2{0, 1}));
    EXPECT_EQ(upright.half_length, 2.5);
    EXPECT_FALSE(pca_box(std::vector<Vec2>{}).ok());
}

}  // namespace
}  // namespace jostle::test
