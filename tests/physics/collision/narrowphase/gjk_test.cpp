// SPDX-License-Identifier: MIT
//
// Closest points of cores, warm starts, and when it may stop early.
#include "physics/src/collision/narrowphase/gjk.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/placed_convex.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Gjk, distance_of_boxes_corner_to_corner_is_the_diagonal) {
    const Geometry box = Box{{1, 1, 1}};
    const GjkResult g = gjk(at(box, {}), at(box, {4, 4, 3}), {});
    EXPECT_NEAR(g.distance, 3, 1e-9);  // (2, 2, 1)
    EXPECT_TRUE(near(g.normal, Vec3{2, 2, 1} * (1.0 / 3), 1e-9));
    EXPECT_TRUE(near(g.on_a, {1, 1, 1}, 1e-9));
    EXPECT_TRUE(near(g.on_b, {3, 3, 2}, 1e-9));
}

// Of a ball and a capsule only the point and the segment count here.
TEST(Gjk, ignores_radii) {
    const Geometry ball = Sphere{0.5}, rod = Capsule{0.1, 2};
    EXPECT_NEAR(gjk(at(ball, {3, 1, 0}), at(rod, {}), {}).distance, 3, 1e-9);
    EXPECT_NEAR(gjk(at(ball, {3, 6, 0}), at(rod, {}), {}).distance, 5, 1e-9);
}

// Random pairs: the points are as far apart as it says, along the normal, and no point of either
// lies between the two planes across it.
TEST(Gjk, normal_separates_and_points_attain_the_distance) {
    Random random(101);
    constexpr ShapeKind kinds[] = {ShapeKind::capsule, ShapeKind::box, ShapeKind::cylinder,
                                   ShapeKind::cone, ShapeKind::hull};
    int apart = 0;
    for (int round = 0; round < 2000; round++) {
        const Geometry ga = random_geometry(kinds[random.below(5)], random);
        const Geometry gb = random_geometry(kinds[random.below(5)], random);
        const Convex a = at(ga, {}, random.rotation());
        const Convex b = at(gb, random.vector(3), random.rotation());
        const GjkResult g = gjk(a, b, {});
        if (g.distance == 0) continue;
        apart++;
        ASSERT_NEAR(length(g.normal), 1, 1e-9);
        EXPECT_NEAR(dot(g.on_b - g.on_a, g.normal), g.distance, 1e-6) << round;
        EXPECT_NEAR(length(g.on_b - g.on_a), g.distance, 1e-6) << round;
        const double gap = dot(support(b, -g.normal) - support(a, g.normal), g.normal);
        EXPECT_NEAR(gap, g.distance, 1e-6) << round;
    }
    EXPECT_GT(apart, 1000);
}

// Overlapping cores: the origin is on the inner side of every face of the simplex.
TEST(Gjk, simplex_of_overlapping_cores_contains_the_origin) {
    Random random(102);
    int tetrahedra = 0;
    for (int round = 0; round < 200; round++) {
        const Geometry ga = random_geometry(ShapeKind::hull, random);
        const Geometry gb = random_geometry(ShapeKind::box, random);
        const Convex a = at(ga, {}, random.rotation());
        Convex b = at(gb, {}, random.rotation());
        b.position = middle_of(a);
        const GjkResult g = gjk(a, b, random.direction());
        ASSERT_EQ(g.distance, 0);
        const auto& p = g.simplex.point;
        if (g.simplex.count < 4) continue;
        tetrahedra++;
        constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
        for (const auto& f : faces) {
            const Vec3 n = normalized(cross(p[f[1]].w - p[f[0]].w, p[f[2]].w - p[f[0]].w));
            const double inside = dot(n, p[f[3]].w - p[f[0]].w), origin = -dot(n, p[f[0]].w);
            EXPECT_GE(origin * (inside < 0 ? -1 : 1), -1e-9) << round;
        }
    }
    EXPECT_GT(tetrahedra, 150);
}

// The normal of the step before, when they hardly moved, takes two rounds; the one that points away
// takes more.
TEST(Gjk, converges_in_two_iterations_from_a_good_hint) {
    Random random(103);
    int good = 0, bad = 0;
    for (int round = 0; round < 200; round++) {
        const Geometry ga = random_geometry(ShapeKind::hull, random);
        const Geometry gb = random_geometry(ShapeKind::hull, random);
        const Convex a = at(ga, {}, random.rotation());
        Convex b = at(gb, random.direction() * 3, random.rotation());
        const Vec3 normal = gjk(a, b, {}).normal;
        b.position += random.vector(1e-4);
        const GjkResult with = gjk(a, b, normal), against = gjk(a, b, -normal);
        EXPECT_NEAR(with.distance, against.distance, 1e-9);
        good += with.rounds;
        bad += against.rounds;
    }
    EXPECT_LE(good, 440) << "in 200 pairs";
    EXPECT_GT(bad, 600);
}

TEST(Gjk, stops_once_the_distance_exceeds_the_limit) {
    const Geometry ball = Cylinder{1, 1};
    const Convex a = at(ball, {}), b = at(ball, {6, 5, 4}, from_axis_angle({1, 0, 1}, 0.7));
    const GjkResult exact = gjk(a, b, {}), early = gjk(a, b, {}, {.beyond = 0.1});
    EXPECT_GT(early.distance, 0.1);
    EXPECT_LE(early.distance, exact.distance + 1e-9) << "a lower bound";
    EXPECT_LE(early.rounds, exact.rounds);
}

}  // namespace
}  // namespace jostle::test
