// SPDX-License-Identifier: MIT
//
// Triangles of meshes and height fields, and what lies across their edges.
#include "physics/src/geometry/surface.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Surface, mesh_folds_are_independent_of_winding) {
    // A roof: two slopes that meet at a ridge along x; the second wound the other way round.
    const std::vector<Vec3> vertices{{0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const bool flipped : {false, true}) {
        const std::array<std::uint32_t, 3> other =
            flipped ? std::array<std::uint32_t, 3>{0, 3, 1} : std::array<std::uint32_t, 3>{0, 1, 3};
        const Geometry mesh = Mesh{must(
            build_mesh(vertices, std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, other}))};
        const SurfaceTriangle t = triangle_of(mesh, 0);
        ASSERT_GT(normal_of(t).y, 0.5);
        const SurfaceEdge ridge = edge_of(mesh, t, 2);
        EXPECT_FALSE(ridge.border);
        EXPECT_LT(ridge.fold, -0.5) << "the far corner lies below: a ridge";
        EXPECT_TRUE(near(ridge.normal, normalized(Vec3{0, 1, -1}), 1e-12));
        EXPECT_TRUE(edge_of(mesh, t, 0).border);
    }
}

TEST(Surface, height_field_triangles_match_the_documented_layout) {
    HeightGrid grid{.columns = 4, .rows = 3, .spacing_x = 2, .spacing_z = 3, .heights = {}};
    for (int i = 0; i < 12; i++) grid.heights.push_back(i);
    const Geometry field = HeightField{must(build_height_field(grid))};
    // Cell (1, 1), first half: samples (1,1), (2,2), (2,1).
    const SurfaceTriangle t = triangle_of(field, (1 * 3 + 1) * 2);
    EXPECT_TRUE(near(t.corner[0], {-1, 5, 0}, 1e-12));
    EXPECT_TRUE(near(t.corner[1], {1, 10, 3}, 1e-12));
    EXPECT_TRUE(near(t.corner[2], {1, 6, 0}, 1e-12));
    EXPECT_GT(normal_of(t).y, 0);
    // Across its diagonal lies the other half of the cell, across its second side the next column.
    int seen = 0;
    for_each_triangle(field, Aabb{{-100, -100, -100}, {100, 100, 100}},
                      [&](const SurfaceTriangle& s) {
                          seen++;
                          EXPECT_GT(normal_of(s).y, 0);
                          for (int k = 0; k < 3; k++) {
                              const SurfaceEdge e = edge_of(field, s, k);
                              EXPECT_NEAR(e.border ? 0 : e.fold, 0, 1e-9) << "the field is a plane";
                          }
                      });
    EXPECT_EQ(seen, 12);
}

TEST(Surface, folds_are_tangents_of_half_the_angle_between_normals) {
    // Two slopes of 45 degrees meet at a right angle: half of it is 45 degrees.
    const auto roof = [](double middle) {
        const std::vector<Vec3> vertices{{0, middle, 0}, {1, middle, 0}, {0, 0, 1}, {0, 0, -1}};
        return Geometry{Mesh{must(build_mesh(
            vertices, std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, {0, 1, 3}}))}};
    };
    for (const double middle : {1.0, -1.0}) {
        const Geometry mesh = roof(middle);
        const SurfaceTriangle t = triangle_of(mesh, 0);
        const SurfaceFolds folds = folds_of(mesh, t, normal_of(t));
        EXPECT_NEAR(folds.at[2], middle, 1e-6) << "a ridge is positive, a valley negative";
        EXPECT_EQ(folds.at[0], no_neighbour_fold);
        EXPECT_EQ(folds.at[1], no_neighbour_fold);
    }
}

TEST(Surface, height_fields_and_meshes_have_the_same_folds) {
    HeightGrid grid{.columns = 4, .rows = 5, .spacing_x = 0.5, .spacing_z = 0.7, .heights = {}};
    for (int i = 0; i < 20; i++) grid.heights.push_back(0.1 * ((i * 7) % 11));
    grid.holes.assign(12, 0);
    grid.holes[4] = 1;
    const Geometry field = HeightField{must(build_height_field(grid))};
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<SurfaceTriangle> of_field;
    for_each_triangle(field, Aabb{{-9, -9, -9}, {9, 9, 9}}, [&](const SurfaceTriangle& t) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3 corner : t.corner) vertices.push_back(corner);
        triangles.push_back({first, first + 1, first + 2});
        of_field.push_back(t);
    });
    const Geometry mesh = Mesh{must(build_mesh(vertices, triangles))};
    ASSERT_EQ(of_field.size(), 22u);
    for (std::uint32_t i = 0; i < of_field.size(); i++) {
        const SurfaceFolds a = folds_of(field, of_field[i], normal_of(of_field[i]));
        const SurfaceFolds b = folds_of(mesh, triangle_of(mesh, i), {});
        for (int k = 0; k < 3; k++) {
            if (b.at[k] == no_neighbour_fold)
                EXPECT_EQ(a.at[k], no_neighbour_fold);
            else
                EXPECT_NEAR(a.at[k], b.at[k], 1e-6);
        }
    }
}

}  // namespace
}  // namespace jostle::test
