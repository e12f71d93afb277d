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

}  // namespace
}  // namespace jostle::test
