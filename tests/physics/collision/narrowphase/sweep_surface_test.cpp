// SPDX-License-Identifier: MIT
//
// Sweeps onto meshes and height fields against the search that continuous collision does triangle
// by triangle, without order or bounds (collision/narrowphase/time_of_impact.h).
#include "physics/src/collision/narrowphase/sweep_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/geometry/shape_measures.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

double hill(double x, double z, double height) {
    return height * sin_cos(0.9 * x).sin * sin_cos(0.7 * z).cos;
}

Geometry hills_of_mesh(int cells, double spacing, double height) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int i = 0; i <= cells; i++)
        for (int j = 0; j <= cells; j++) {
            const double x = (i - 0.5 * cells) * spacing, z = (j - 0.5 * cells) * spacing;
            vertices.push_back({x, hill(x, z, height), z});
        }
    const auto n = static_cast<std::uint32_t>(cells);
    for (std::uint32_t i = 0; i < n; i++)
        for (std::uint32_t j = 0; j < n; j++) {
            const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
            triangles.push_back({a, a + 1, b});
            triangles.push_back({b, a + 1, b + 1});
        }
    return Mesh{build_mesh(vertices, triangles).value()};
}

Geometry hills_of_field(std::uint32_t cells, double spacing, double height) {
    HeightGrid grid;
    grid.columns = grid.rows = cells + 1;
    grid.spacing_x = grid.spacing_z = spacing;
    for (std::uint32_t r = 0; r <= cells; r++)
        for (std::uint32_t c = 0; c <= cells; c++)
            grid.heights.push_back(
                hill((c - 0.5 * cells) * spacing, (r - 0.5 * cells) * spacing, height));
    grid.holes.assign(std::size_t{cells} * cells, 0);
    grid.holes[cells / 2] = 1;
    return HeightField{build_height_field(std::move(grid)).value()};
}

struct Sweeper {
    Geometry geometry;
    Transform pose;
    Vec3 motion;
    double gap() const { return 1e-6 * radius_of(geometry); }
};

// By the other search: never, at the start (0), or the fraction.
double touch_by_search(const Geometry& surface, const Transform& at, const Sweeper& s) {
    if (shapes_overlap(transformed_shape(s.geometry, s.pose), transformed_shape(surface, at)))
        return 0;
    const SweptShape moving{.geometry = &s.geometry,
                            .offset = {},
                            .axes = to_matrix(Quat{}),
                            .radius = radius_of(s.geometry),
                            .sweep = {0, s.pose.position, s.pose.rotation, s.motion, {}}};
    const SweptShape still{.geometry = &surface,
                           .offset = {},
                           .axes = to_matrix(at.rotation),
                           .radius = radius_of(surface),
                           .sweep = {0, at.position, {}, {}, {}}};
    const Impact impact = time_of_impact(moving, still, 0, s.gap());
    return impact.at_start ? 0 : impact.fraction;
}

struct Score {
    int hits = 0, misses = 0, inside = 0;
    double worst = 0;  // m along the motion, in gaps
};

void compare(const Geometry& surface, const Transform& at, const Sweeper& s, Score& score) {
    const auto touch = sweep_to_surface(transformed_shape(surface, at),
                                        transformed_shape(s.geometry, s.pose), s.motion, s.gap());
    const double expected = touch_by_search(surface, at, s);
    if (expected > 1) {
        score.misses++;
        EXPECT_FALSE(touch.has_value() && touch->fraction < 1 - 1e-5);
        return;
    }
    ASSERT_TRUE(touch.has_value());
    (expected == 0 ? score.inside : score.hits)++;
    if (expected == 0) {
        EXPECT_EQ(touch->fraction, 0);
        return;
    }
    ASSERT_TRUE(touch->settled);
    EXPECT_NEAR(length(touch->normal), 1, 1e-9);
    // Both stop within twice the gap; along a grazing way that is a long way.
    const double slope = maximum(-dot(touch->normal, normalized(s.motion)), 0.02);
    const double apart = absolute(touch->fraction - expected) * length(s.motion) * slope;
    score.worst = std::max(score.worst, apart / s.gap());
}

TEST(SweepSurface, matches_a_search_over_every_triangle) {
    Random random(5);
    const ShapeKind kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                               ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};
    for (const bool field : {false, true}) {
        Score score;
        for (const double spacing : {0.2, 1.0, 4.0}) {
            const Geometry surface =
                field ? hills_of_field(24, spacing, 0.6) : hills_of_mesh(24, spacing, 0.6);
            const Transform at{{3, -2, 1}, random.rotation()};
            for (int k = 0; k < 250; k++) {
                const Geometry geometry = random_geometry(kinds[k % 6], random);
                const double wide = 12 * spacing;
                const Vec3 above{random.in(-wide, wide), random.in(0.5, 4), random.in(-wide, wide)};
                const Vec3 local{random.in(-4, 4), random.in(-8, 1), random.in(-4, 4)};
                const Vec3 motion = rotate(at.rotation, local);
                compare(surface, at, {geometry, {apply(at, above), random.rotation()}, motion},
                        score);
            }
        }
        RecordProperty(field ? "field_worst_gaps" : "mesh_worst_gaps", std::to_string(score.worst));
        EXPECT_GT(score.hits, 250);
        EXPECT_GT(score.misses, 50);
        EXPECT_GT(score.inside, 20);
        EXPECT_LT(score.worst, 3);
    }
}

// 60 m over a hillside: taken in parts, it is what it would be in one.
TEST(SweepSurface, long_sweep_equals_its_parts) {
    Random random(6);
    const Geometry surface = hills_of_mesh(60, 1, 1.5);
    Score score;
    for (int k = 0; k < 60; k++) {
        const Cylinder wheel{random.in(0.1, 0.5), random.in(0.05, 0.3)};
        const Vec3 from{random.in(-30, -20), random.in(1.6, 4), random.in(-30, 30)};
        const Vec3 to{random.in(10, 30), random.in(-2, 3), random.in(-30, 30)};
        compare(surface, {}, {wheel, {from, random.rotation()}, to - from}, score);
    }
    EXPECT_GT(score.hits, 20);
    EXPECT_LT(score.worst, 3);
}

// Nothing that slides over flat triangles feels the edges between them.
TEST(SweepSurface, seams_of_flat_ground_have_the_ground_normal) {
    Random random(7);
    const Geometry surface = hills_of_mesh(16, 0.25, 0);
    const Geometry shapes[] = {Sphere{0.3}, Capsule{0.2, 0.4}, Box{{0.3, 0.2, 0.4}},
                               Cylinder{0.33, 0.11}, Cone{0.3, 0.3}};
    double worst = 0;
    for (int k = 0; k < 500; k++) {
        const Vec3 from{random.in(-1.2, 1.2), random.in(1, 2), random.in(-1.2, 1.2)};
        // Half of them level.
        const Quat turn = k % 2 == 0 ? Quat{} : random.rotation();
        const Geometry& shape = shapes[k % 5];
        const auto touch =
            sweep_to_surface(transformed_shape(surface, {}), transformed_shape(shape, {from, turn}),
                             {0, -3, 0}, 1e-6 * radius_of(shape));
        ASSERT_TRUE(touch.has_value());
        ASSERT_TRUE(touch->settled);
        worst = std::max(worst, length(touch->normal - Vec3{0, 1, 0}));
        EXPECT_NEAR(touch->point.y, 0, 1e-9);
    }
    RecordProperty("worst_normal", std::to_string(worst));
    EXPECT_LT(worst, 1e-5);
}

// What begins in the plane of a wall and goes along it does not meet it.
TEST(SweepSurface, sweep_parallel_to_a_wall_does_not_hit_it) {
    const Geometry wall = hills_of_mesh(8, 1, 0);
    const Sphere ball{0.5};
    const Geometry shape = ball;
    const auto past =
        sweep_to_surface(transformed_shape(wall, {}),
                         transformed_shape(shape, {{-2, 0.5 + 1e-4, 0}, {}}), {4, 0, 0}, 5e-7);
    EXPECT_FALSE(past.has_value());
    const auto into =
        sweep_to_surface(transformed_shape(wall, {}),
                         transformed_shape(shape, {{-2, 0.5 + 1e-4, 0}, {}}), {4, -1e-3, 0}, 5e-7);
    ASSERT_TRUE(into.has_value());
    EXPECT_NEAR(into->fraction, 0.1, 1e-3);
}

}  // namespace
}  // namespace jostle::test
