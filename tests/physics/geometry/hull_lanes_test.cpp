// SPDX-License-Identifier: MIT
//
// What hulls show side by side is what loops over their parts find, or a little more.
#include "physics/src/geometry/hull_lanes.h"

#include <gtest/gtest.h>

#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

std::shared_ptr<const ConvexHull> hull_of(Random& random) {
    return std::get<Hull>(random_geometry(ShapeKind::hull, random)).data;
}

TEST(HullLanes, returns_the_first_of_equally_far_vertices) {
    const Vec3 corners[] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                            {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
    const auto hull = build_hull(corners).value();
    const auto loop = [&](Vec3 d) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < hull->vertices.size(); k++)
            if (dot(hull->vertices[k], d) > dot(hull->vertices[best], d)) best = k;
        return best;
    };
    for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 1, 1}, Vec3{-1, 0, 2}, Vec3{}})
        EXPECT_EQ(furthest_vertex(*hull->lanes, d), loop(d)) << d.x << ' ' << d.y << ' ' << d.z;
    Random random(5);
    for (int round = 0; round < 2000; round++) {
        const Vec3 d = random.direction();
        EXPECT_EQ(furthest_vertex(*hull->lanes, d), loop(d));
    }
}

// 300 hulls, two pairs of balls each, some far off: no bound is below what a thousand directions
// of an arc show, and none is more than 1e-4 of the way between the balls above it.
TEST(HullLanes, no_normal_exceeds_its_bound) {
    Random random(6);
    for (int round = 0; round < 300; round++) {
        const auto hull = hull_of(random);
        const InnerBalls balls[] = {{random.vector(round % 3 == 0 ? 50 : 2), 0.1},
                                    {random.vector(2), 0}};
        const double sign = round % 2 == 0 ? 1 : -1;
        const auto shown = [&](Vec3 n) {
            double least = 1e300;
            for (const InnerBalls& ball : balls)
                least = minimum(least, sign * dot(n, ball.apart) - ball.radii);
            return least;
        };
        const double far = length(balls[0].apart) + length(balls[1].apart);
        alignas(16) float most[3 * max_hull_vertices + 8];
        show_normals(*hull->lanes, balls, sign, most);
        for (std::size_t k = 0; k < hull->faces.size(); k++) {
            EXPECT_GE(double{most[k]}, shown(hull->faces[k].normal));
            EXPECT_NEAR(double{most[k]}, shown(hull->faces[k].normal), 1e-4 * far);
        }
        show_arcs(*hull->lanes, balls, sign, most);
        for (std::size_t k = 0; k < hull->edges.size(); k++) {
            const Vec3 first = hull->faces[hull->edges[k].left].normal,
                       second = hull->faces[hull->edges[k].right].normal;
            double of_one[2] = {-1e300, -1e300}, of_both = -1e300;
            for (int step = 0; step <= 1000; step++) {
                const double part = step / 1000.0;
                const Vec3 n = normalized(first * (1 - part) + second * part);
                of_both = maximum(of_both, shown(n));
                for (int b = 0; b < 2; b++)
                    of_one[b] = maximum(of_one[b], sign * dot(n, balls[b].apart) - balls[b].radii);
            }
            EXPECT_GE(double{most[k]}, of_both);
            EXPECT_NEAR(double{most[k]}, minimum(of_one[0], of_one[1]), 1e-4 * far);
        }
    }
}

}  // namespace
}  // namespace jostle::test
