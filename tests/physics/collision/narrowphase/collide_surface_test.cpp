// SPDX-License-Identifier: MIT
//
// Shapes over gently curved and flat meshes, where most triangles near a shape belong to their
// neighbours' contacts. Sharp meshes: collide_composite_test.cpp.
#include "physics/src/collision/narrowphase/collide_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "jostle/physics/mesh.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/geometry/shape_measures.h"
#include "tests/support/random_shapes.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double terrain_margin = 0.05;  // m
constexpr int terrain_cells = 16;        // of 0.3 m, along each side

Geometry terrain_of(const std::function<double(double x, double z)>& height, bool flipped = false) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int r = 0; r <= terrain_cells; r++)
        for (int c = 0; c <= terrain_cells; c++) {
            const double x = 0.3 * (c - terrain_cells / 2), z = 0.3 * (r - terrain_cells / 2);
            vertices.push_back({x, height(x, z), z});
        }
    for (std::uint32_t r = 0; r < terrain_cells; r++)
        for (std::uint32_t c = 0; c < terrain_cells; c++) {
            const std::uint32_t a = r * (terrain_cells + 1) + c, b = a + terrain_cells + 1;
            triangles.push_back({a, flipped ? a + 1 : b, flipped ? b : a + 1});
            triangles.push_back({a + 1, flipped ? b + 1 : b, flipped ? b : b + 1});
        }
    return Mesh{must(build_mesh(vertices, triangles))};
}
double gentle_hills(double x, double z) {
    return 0.2 * std::sin(1.3 * x) * std::cos(1.1 * z) + 0.03 * std::sin(3 * x + z);
}

// The distance of a shape from the nearest triangle; 0 if they overlap.
double distance_to_terrain(const Geometry& surface, const TransformedShape& shape) {
    double least = 1e300;
    const Convex convex = convex_of(shape, {});
    for_each_triangle(surface, grow(bounds_of(shape), 0.2), [&](const SurfaceTriangle& t) {
        const double apart = gjk(triangle_convex(t.corner, {}, {}), convex, {}).distance;
        least = minimum(least, maximum(0, apart - convex.radius));
    });
    return least;
}

double deepest_gap_of(const std::vector<Manifold>& manifolds) {
    double least = 1e300;
    for (const Manifold& m : manifolds)
        for (int k = 0; k < m.count; k++) least = minimum(least, m.gap[k]);
    return least;
}

class SurfaceContacts : public testing::TestWithParam<ShapeKind> {};

TEST_P(SurfaceContacts, show_the_distance_of_the_nearest_triangle) {
    int near = 0;
    for (const bool flipped : {false, true}) {
        const Geometry surface = terrain_of(gentle_hills, flipped);
        const TransformedShape ground = transformed_shape(surface, Transform{});
        for (std::uint64_t seed = 0; seed < 40; seed++) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << " flipped " << flipped);
            Random random(64000 + seed * 16 + static_cast<std::uint64_t>(GetParam()));
            const Geometry geometry = random_geometry(GetParam(), random);
            Vec3 at = random.vector(1);
            const Quat rotation = random_rotation(random);
            at.y = 5;
            const double target = random.in(0.001, 0.04);
            TransformedShape shape = transformed_shape(geometry, Transform{at, rotation});
            // Lower it until it is `target` away.
            for (int k = 0; k < 60; k++) {
                std::vector<Manifold> below;
                collide_surface(ground, shape, k == 0 ? 8 : 0.5, nullptr, {}, below);
                if (below.empty()) break;
                const double apart = distance_to_terrain(surface, shape);
                const double gap = apart < 0.2 ? apart : deepest_gap_of(below);
                if (std::fabs(gap - target) < 1e-3) break;
                shape.position.y -= 0.9 * (gap - target);
            }
            const double truth = distance_to_terrain(surface, shape);
            if (truth < 1e-4 || truth > terrain_margin - 1e-3) continue;
            near++;
            std::vector<Manifold> manifolds;
            collide_surface(ground, shape, terrain_margin, nullptr, {}, manifolds);
            EXPECT_NEAR(deepest_gap_of(manifolds), truth, 1e-4 + 0.01 * truth);
        }
    }
    EXPECT_GT(near, 15);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SurfaceContacts,
                         testing::Values(ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box,
                                         ShapeKind::cylinder, ShapeKind::cone, ShapeKind::hull));

TEST(CollideSurface, a_box_on_flat_triangles_has_one_manifold_that_points_up) {
    const Geometry surface = terrain_of([](double, double) { return 0.0; });
    const Geometry box = Box{{0.5, 0.2, 0.4}};
    for (const double overlap : {0.0, 1e-4, 2e-3, 1e-2})
        for (std::uint64_t seed = 0; seed < 40; seed++) {
            Random random(seed);
            const double angle = random.in(0, 3);
            const Quat turn{0, std::sin(angle / 2), 0, std::cos(angle / 2)};
            const Vec3 at{random.in(-1, 1), 0.2 - overlap, random.in(-1, 1)};
            std::vector<Manifold> manifolds;
            collide_surface(transformed_shape(surface, Transform{}),
                            transformed_shape(box, Transform{at, turn}), terrain_margin, nullptr,
                            {}, manifolds);
            ASSERT_EQ(manifolds.size(), 1u);
            EXPECT_EQ(manifolds[0].count, 4);
            EXPECT_GT(manifolds[0].normal.y, 1 - 1e-12);
            for (int k = 0; k < 4; k++) EXPECT_NEAR(manifolds[0].gap[k], -overlap, 1e-9);
        }
}

TEST(CollideSurface, a_box_over_a_gentle_ridge_touches_both_slopes_from_above) {
    // Slopes of 0.1 on both sides of x = 0.
    const Geometry surface = terrain_of([](double x, double) { return -0.1 * std::fabs(x); });
    const Geometry box = Box{{0.5, 0.2, 0.4}};
    std::vector<Manifold> manifolds;
    collide_surface(transformed_shape(surface, Transform{}),
                    transformed_shape(box, Transform{{0.05, 0.2 + 1e-3, 0.05}, Quat{}}),
                    terrain_margin, nullptr, {}, manifolds);
    EXPECT_NEAR(deepest_gap_of(manifolds), 1e-3, 1e-4);
    for (const Manifold& m : manifolds) EXPECT_GT(m.normal.y, 0.99);
}

}  // namespace
}  // namespace jostle::test
