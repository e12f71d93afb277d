// SPDX-License-Identifier: MIT
//
// Triangles to mesh: neighbours, what is dropped, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/surface.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

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
        std::vector<ChildManifold> parts;
        collide_composite(transformed_shape(ground, {}),
                          transformed_shape(*shape, {random.vector(2), random.rotation()}), 0.1,
                          parts);
        for (const ChildManifold& part : parts)
            for (int k = 0; k < part.manifold.count; k++)
                EXPECT_TRUE(is_finite(part.manifold.point[k]) && is_finite(part.manifold.gap[k]) &&
                            is_finite(part.manifold.normal));
    }
}

// Vertices at the same places, in lines, far away or not numbers; triangles that are points, occur
// twice, share an edge by three, or name what is not there.
TEST(MeshBuilder, ten_thousand_random_triangle_soups_are_built_or_rejected) {
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

TEST(MeshBuilder, errors_name_the_problem) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NE(build_mesh(vertices, Triangles{{0, 1, 3}}).error().message.find("vertex 3"),
              std::string::npos);
    EXPECT_NE(build_mesh(vertices, Triangles{}).error().message.find("no triangles"),
              std::string::npos);
    EXPECT_NE(build_mesh(vertices, Triangles{{0, 0, 1}}).error().message.find("degenerate"),
              std::string::npos);
    EXPECT_EQ(must(build_mesh(vertices, Triangles{{0, 1, 2}, {1, 1, 2}}))->triangles.size(), 1u);
}

// Two triangles of one square whose corners are given twice: they are neighbours by place. A third
// on the same edge makes it nobody's.
TEST(MeshBuilder, coincident_vertices_are_merged_for_adjacency) {
    std::vector<Vec3> vertices{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    const auto square = must(build_mesh(vertices, Triangles{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(square->neighbours[0], (std::array<std::uint32_t, 3>{no_triangle, 1, no_triangle}));
    EXPECT_EQ(square->neighbours[1], (std::array<std::uint32_t, 3>{0, no_triangle, no_triangle}));
    EXPECT_EQ(square->bounds, (Aabb{{0, 0, 0}, {1, 0, 1}}));
    vertices.push_back({0.5, 1, 0.5});
    const auto fin = must(build_mesh(vertices, Triangles{{0, 1, 2}, {3, 4, 5}, {1, 2, 6}}));
    EXPECT_EQ(fin->neighbours[0][1], no_triangle);
    EXPECT_NE(fin->content_hash, square->content_hash);
}

// A square of two triangles, each with its own corners, up to 0.01 mm from their places.
TEST(MeshBuilder, vertices_within_a_hundredth_of_a_millimetre_are_one) {
    const double d = 1e-5;
    const std::vector<Vec3> vertices{{d, -d, 0},     {-d, d, 1}, {1, d, d},
                                     {1 - d, -d, 0}, {d, 0, 1},  {1, d, 1 + d}};
    const auto square = must(build_mesh(vertices, Triangles{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(square->neighbours[0], (std::array<std::uint32_t, 3>{no_triangle, 1, no_triangle}));
    EXPECT_EQ(square->vertices[0], (Vec3{d, -d, 0}));
    // In a mesh of 0.1 mm the same distance is a feature.
    std::vector<Vec3> tiny = vertices;
    for (Vec3& v : tiny)
        v = {std::round(v.x) * 1e-4 + d * (v.x - std::round(v.x)) / d, 0, std::round(v.z) * 1e-4};
    EXPECT_EQ(must(build_mesh(tiny, Triangles{{0, 1, 2}, {3, 4, 5}}))->neighbours[0][1],
              no_triangle);
}

TEST(MeshBuilder, repeated_triangles_are_dropped) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    const auto square = must(
        build_mesh(vertices, Triangles{{0, 1, 2}, {1, 2, 0}, {2, 1, 3}, {2, 1, 0}, {2, 3, 4}}));
    EXPECT_EQ(square->triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(square->neighbours[0][1], 1u);
}

}  // namespace
}  // namespace jostle::test
