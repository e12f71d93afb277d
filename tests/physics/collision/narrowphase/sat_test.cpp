// SPDX-License-Identifier: MIT
//
// The separating axis of polyhedra: faces, edges, and the one of the last time.
#include "physics/src/collision/narrowphase/sat.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/near.h"
#include "tests/support/placed_convex.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

const Geometry cube = Box{};

TEST(Sat, separation_of_cubes_is_exact) {
    const Separation apart = separate(at(cube, {}), at(cube, {1.5, 0.2, 0}), 0, 1e300);
    EXPECT_NEAR(apart.distance, 0.5, 1e-12);
    EXPECT_TRUE(near(apart.normal, {1, 0, 0}, 1e-12));
    EXPECT_NEAR(apart.on_b.x - apart.on_a.x, 0.5, 1e-12);
    const Separation deep = separate(at(cube, {}), at(cube, {0.2, -0.9, 0.3}), 0, 1e300);
    EXPECT_NEAR(deep.distance, -0.1, 1e-12);
    EXPECT_TRUE(near(deep.normal, {0, -1, 0}, 1e-12));
}

// Two cubes on their edges, which cross at a right angle: each reaches sqrt(1/2) towards the other.
TEST(Sat, crossing_edges_separate_along_their_cross_product) {
    const Convex a = at(cube, {}, from_axis_angle({0, 0, 1}, pi / 4));
    const Convex b = at(cube, {2, 0, 0}, from_axis_angle({0, 1, 0}, pi / 4));
    const Separation s = separate(a, b, 0, 1e300);
    EXPECT_NEAR(s.distance, 2 - square_root(2), 1e-12);
    EXPECT_TRUE(near(s.normal, {1, 0, 0}, 1e-12));
    EXPECT_TRUE(near(s.on_a, {square_root(0.5), 0, 0}, 1e-12));
    EXPECT_TRUE(near(s.on_b, {2 - square_root(0.5), 0, 0}, 1e-12));
}

// A cube that sits in another's corner by a diagonal is as deep along x as along y: whichever axis
// it had it keeps, so that the normal of a resting contact does not flicker.
TEST(Sat, keeps_the_last_axis_on_ties) {
    const auto along = [](Vec3 position, AxisCode cached) {
        return separate(at(cube, {}), at(cube, position), cached, 1e300);
    };
    const Separation x = along({0.9, 0.8, 0}, 0), y = along({0.8, 0.9, 0}, 0);
    ASSERT_TRUE(near(x.normal, {1, 0, 0}, 1e-12));
    ASSERT_TRUE(near(y.normal, {0, 1, 0}, 1e-12));
    EXPECT_EQ(along({0.9, 0.9, 0}, x.code).normal, x.normal);
    EXPECT_EQ(along({0.9, 0.9, 0}, y.code).normal, y.normal);
    EXPECT_EQ(along({0.9, 0.8, 0}, y.code).normal, x.normal) << "not against a better one";
}

TEST(Sat, stops_at_the_first_sufficient_axis) {
    const Convex a = at(cube, {}), b = at(cube, {2, 5, 0});
    const Separation x = separate(a, b, 0, 0.5), whole = separate(a, b, 0, 1e300);
    EXPECT_GT(x.distance, 0.5);
    EXPECT_NEAR(whole.distance, 4, 1e-12);
    EXPECT_LE(x.distance, whole.distance);
    EXPECT_EQ(separate(a, b, x.code, 0.5).code, x.code) << "the last one is asked first";
}

// Codes are saved with a world: one that fits other shapes must do no harm.
TEST(Sat, ignores_an_invalid_cached_axis) {
    const Convex a = at(cube, {}), b = at(cube, {1.5, 0, 0});
    Random random(131);
    for (int k = 0; k < 2000; k++) {
        const auto code = static_cast<AxisCode>(random.bits() & 0x3fffffff);
        EXPECT_NEAR(separate(a, b, code, 1e300).distance, 0.5, 1e-12) << code;
    }
}

// Random polyhedra that overlap: no direction of many parts them by less.
TEST(Sat, overlap_is_the_minimum_over_all_directions) {
    Random random(132);
    int overlapping = 0;
    for (int round = 0; round < 300; round++) {
        const Geometry ga = random_geometry(ShapeKind::hull, random);
        const Geometry gb = random_geometry(ShapeKind::box, random);
        const Convex a = at(ga, {}, random.rotation());
        const Convex b = at(gb, random.vector(1), random.rotation());
        const Separation s = separate(a, b, 0, 1e300);
        const double along = dot(support(b, -s.normal) - support(a, s.normal), s.normal);
        EXPECT_NEAR(s.distance, along, 1e-5) << round;
        if (s.distance > 0) continue;
        overlapping++;
        for (int k = 0; k < 300; k++) {
            const Vec3 d = random.direction();
            ASSERT_LE(dot(support(b, -d) - support(a, d), d), s.distance + 1e-4) << round;
        }
    }
    EXPECT_GT(overlapping, 100);
}

// Of stones that just overlap most axes are never looked at, whatever axis they had: the answer is
// that of all faces and all products of edges.
TEST(Sat, skipped_axes_are_never_the_best) {
    Random random(133);
    const auto overlap_of_all = [](const Convex& a, const Convex& b) {
        double best = -1e300;
        const auto ask = [&](Vec3 n) {
            if (length(n) < 1e-9) return;
            n = normalized(n);
            for (const Vec3 d : {n, -n})
                best = std::max(best, dot(support(b, -d) - support(a, d), d));
        };
        for (const Convex* c : {&a, &b})
            for (const HullFace& f : c->hull->faces) ask(c->axes * f.normal);
        for (const HullEdge& x : a.hull->edges)
            for (const HullEdge& y : b.hull->edges)
                ask(cross(a.axes * (a.hull->vertices[x.to] - a.hull->vertices[x.from]),
                          b.axes * (b.hull->vertices[y.to] - b.hull->vertices[y.from])));
        return best;
    };
    int by_edges = 0, overlapping = 0;
    for (int round = 0; round < 60; round++) {
        const Geometry ga = random_geometry(ShapeKind::hull, random),
                       gb = random_geometry(ShapeKind::hull, random);
        const Quat turn_a = random.rotation(), turn_b = random.rotation();
        const Vec3 way = random.direction();
        const Convex a = at(ga, {}, turn_a);
        // Moved until it overlaps by a twentieth of its size.
        const double apart = separate(a, at(gb, way * 10, turn_b), 0, 1e300).distance;
        Vec3 place = way * (10 - apart);
        for (int k = 0; k < 20; k++) {
            const Separation s = separate(a, at(gb, place, turn_b), 0, 1e300);
            place = place - s.normal * (s.distance + 0.05 * size_of(a));
        }
        const Convex b = at(gb, place, turn_b);
        const double truth = overlap_of_all(a, b);
        if (truth >= 0) continue;
        overlapping++;
        const Separation fresh = separate(a, b, 0, 1e300);
        by_edges += (fresh.code >> 28) == 3 ? 1 : 0;
        EXPECT_NEAR(fresh.distance, truth, 3e-5 * size_of(a)) << round;
        for (int k = 0; k < 10; k++) {
            const Quat askew = from_axis_angle(random.direction(), 0.3) * turn_b;
            const AxisCode old = separate(a, at(gb, place, askew), 0, 1e300).code;
            EXPECT_NEAR(separate(a, b, old, 1e300).distance, truth, 3e-5 * size_of(a)) << round;
        }
    }
    EXPECT_GT(overlapping, 40);
    EXPECT_GT(by_edges, 10);
}

// A rod over the edge of a cube, square to it: apart along the edge's own normal.
TEST(Sat, separates_a_segment_from_a_polyhedron) {
    const Geometry rod = Capsule{0.1, 1};
    const Convex box = at(cube, {}, from_axis_angle({0, 0, 1}, pi / 4));
    // Along z the rod lies upon the upper edge, along x across it.
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2);
    const Separation across = separate_segment(box, at(rod, {0, 1, 0}, along_x));
    EXPECT_NEAR(across.distance, 1 - square_root(0.5), 1e-12);
    EXPECT_TRUE(near(across.normal, {0, 1, 0}, 1e-12));
    // Upright through its middle it sticks out at both ends: the way out is to a side.
    const Separation stuck = separate_segment(at(cube, {}), at(rod, {0.4, 0, 0}));
    EXPECT_NEAR(stuck.distance, -0.1, 1e-12);
    EXPECT_TRUE(near(stuck.normal, {1, 0, 0}, 1e-12));
}

}  // namespace
}  // namespace jostle::test
