// SPDX-License-Identifier: MIT
//
// Meshes and height fields: neighbours, trees, cells, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision/narrowphase/collide_composite.h"
#include "geometry/bvh.h"
#include "geometry/surface.h"
#include "support/near.h"
#include "support/random.h"
#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Bvh, finds_every_box_that_overlaps_and_no_other) {
    Random random(1);
    for (const int count : {0, 1, 3, 5, 200, 3000}) {
        std::vector<Aabb> boxes;
        for (int i = 0; i < count; i++) {
            const Vec3 at = random.vector(10), half = abs(random.vector(i % 10 == 0 ? 3 : 0.3));
            boxes.push_back(i % 50 == 49 ? boxes.back() : Aabb{at - half, at + half});
        }
        const Bvh tree(boxes);
        EXPECT_LE(tree.height(), 40);
        for (int q = 0; q < 50; q++) {
            const Vec3 at = random.vector(10);
            const Aabb box = grow({at, at}, random.in(0, 3));
            std::vector<std::uint32_t> found, expected;
            tree.query(box, [&](std::uint32_t item) {
                if (overlap(boxes[item], box)) found.push_back(item);
            });
            std::sort(found.begin(), found.end());
            for (std::uint32_t i = 0; i < boxes.size(); i++)
                if (overlap(boxes[i], box)) expected.push_back(i);
            ASSERT_EQ(found, expected);
        }
    }
}

// Ten thousand boxes in one place: no plane parts them, and the tree does not become a chain.
TEST(Bvh, survives_boxes_that_are_all_the_same) {
    const Bvh tree(std::vector<Aabb>(10000, Aabb{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_LE(tree.height(), 20);
    int met = 0;
    tree.query({{0, 0, 0}, {1, 1, 1}}, [&](std::uint32_t) { met++; });
    EXPECT_EQ(met, 10000);
}

TEST(Surface, mesh_knows_folds_whatever_the_winding) {
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

TEST(Surface, height_field_triangles_lie_where_the_header_says) {
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

// Every triangle of what was built is found by its own box, knows its neighbours as they know it,
// and collides with numbers.
void check_mesh(const std::shared_ptr<const TriangleMesh>& mesh, Random& random) {
    for (std::uint32_t t = 0; t < mesh->triangles.size(); t++) {
        bool found = false;
        const Vec3 a = triangle_of(*mesh, t).corner[0];
        mesh->tree->query({a, a}, [&](std::uint32_t k) { found = found || k == t; });
        EXPECT_TRUE(found) << t;
        for (const std::uint32_t other : mesh->neighbours[t]) {
            if (other == 0xffffffff) continue;
            const auto& back = mesh->neighbours[other];
            EXPECT_NE(std::find(back.begin(), back.end(), t), back.end()) << t << ", " << other;
        }
    }
    const Geometry ground = Mesh{mesh}, ball = Sphere{1}, box = Box{{1, 0.5, 2}};
    for (const Geometry* shape : {&ball, &box}) {
        std::vector<PartManifold> parts;
        collide_composite(placed(ground, {}), placed(*shape, {random.vector(2), random.rotation()}),
                          0.1, parts);
        for (const PartManifold& part : parts)
            for (int k = 0; k < part.manifold.count; k++)
                EXPECT_TRUE(is_finite(part.manifold.point[k]) && is_finite(part.manifold.gap[k]) &&
                            is_finite(part.manifold.normal));
    }
}

// Vertices at the same places, in lines, far away or not numbers; triangles that are points, occur
// twice, share an edge by three, or name what is not there.
TEST(Surface, ten_thousand_soups_of_triangles_are_built_or_refused) {
    Random random(99);
    int built = 0;
    for (int i = 0; i < 10000; i++) {
        SCOPED_TRACE(i);
        std::vector<Vec3> vertices;
        const auto count = random.below(12);
        const bool on_grid = random.below(2) == 0;
        for (std::uint64_t k = 0; k < count; k++) {
            Vec3 p = random.vector(2);
            if (on_grid) p = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
            if (random.below(400) == 0) p.x = std::nan("");
            if (random.below(400) == 0) p.y = 1e30;
            vertices.push_back(p);
        }
        std::vector<std::array<std::uint32_t, 3>> triangles(random.below(15));
        for (auto& triangle : triangles)
            for (std::uint32_t& corner : triangle)
                corner = static_cast<std::uint32_t>(random.below(count + 1 + i % 2) % 12);
        const auto mesh = build_mesh(vertices, triangles);
        if (!mesh.ok()) {
            EXPECT_NE(mesh.error().message.find("mesh: "), std::string::npos);
            continue;
        }
        built++;
        check_mesh(*mesh, random);
    }
    EXPECT_GT(built, 500);
}

TEST(Surface, builders_say_what_is_wrong) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    EXPECT_NE(build_mesh(vertices, Triangles{{0, 1, 3}}).error().message.find("vertex 3"),
              std::string::npos);
    EXPECT_NE(build_mesh(vertices, Triangles{}).error().message.find("no triangles"),
              std::string::npos);
    EXPECT_NE(build_mesh(vertices, Triangles{{0, 0, 1}}).error().message.find("area"),
              std::string::npos);
    EXPECT_EQ(must(build_mesh(vertices, Triangles{{0, 1, 2}, {1, 1, 2}}))->triangles.size(), 1u);
    EXPECT_FALSE(build_height_field({.columns = 2, .rows = 2, .heights = {0, 0, 0}}).ok());
    EXPECT_FALSE(build_height_field({.columns = 1, .rows = 2, .heights = {0, 0}}).ok());
    EXPECT_FALSE(
        build_height_field({.columns = 2, .rows = 2, .spacing_x = -1, .heights = {0, 0, 0, 0}})
            .ok());
    EXPECT_FALSE(
        build_height_field({.columns = 0xffffffff, .rows = 0xffffffff, .heights = {}}).ok());
    const auto holed = must(
        build_height_field({.columns = 3, .rows = 2, .heights = {0, 0, std::nan(""), 0, 0, 0}}));
    EXPECT_EQ(holed->holes, (std::vector<std::uint8_t>{0, 1})) << "no height, no ground";
    EXPECT_FALSE(build_compound({}).ok());
    EXPECT_FALSE(build_compound({{Plane{}, {}}}).ok());
    EXPECT_FALSE(build_compound({{Sphere{-1}, {}}}).ok());
}

}  // namespace
}  // namespace jostle::test
