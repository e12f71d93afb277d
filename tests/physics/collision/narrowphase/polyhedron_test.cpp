// SPDX-License-Identifier: MIT
//
// Boxes, triangles and hulls as vertices, faces and edges that fit each other.
#include "physics/src/collision/narrowphase/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/near.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

// Corners lie on their faces; edges run round the face on their left and belong to the one on their
// right.
void expect_sound(const Polyhedron& p) {
    for (const HullFace& face : p.faces)
        for (const std::uint16_t v : p.vertices_of(face))
            EXPECT_NEAR(dot(face.normal, p.vertices[v]), face.offset, 1e-5);
    for (const HullEdge& edge : p.edges) {
        const auto left = p.vertices_of(p.faces[edge.left]);
        const auto at = std::find(left.begin(), left.end(), edge.from);
        ASSERT_NE(at, left.end());
        const auto next = at + 1 == left.end() ? left.begin() : at + 1;
        EXPECT_EQ(*next, edge.to);
        const auto right = p.vertices_of(p.faces[edge.right]);
        EXPECT_NE(std::find(right.begin(), right.end(), edge.from), right.end());
        EXPECT_NE(std::find(right.begin(), right.end(), edge.to), right.end());
    }
}

TEST(Polyhedron, a_box_has_six_faces_and_twelve_edges) {
    const Geometry box = Box{{1, 2, 3}};
    PolyhedronParts parts;
    const Polyhedron p = polyhedron_of(convex_of(transformed_shape(box, {}), {}), parts);
    EXPECT_EQ(p.vertices.size(), 8u);
    EXPECT_EQ(p.faces.size(), 6u);
    EXPECT_EQ(p.edges.size(), 12u);
    expect_sound(p);
    for (const HullFace& face : p.faces) {
        const auto loop = p.vertices_of(face);
        const Vec3 turn = cross(p.vertices[loop[1]] - p.vertices[loop[0]],
                                p.vertices[loop[2]] - p.vertices[loop[1]]);
        EXPECT_GT(dot(turn, face.normal), 0) << "counter-clockwise seen from outside";
    }
}

// Both of its sides, and a face of two corners per edge: so every edge has two faces whose normals
// are less than half a turn apart.
TEST(Polyhedron, triangle_is_a_prism_of_zero_height) {
    const Vec3 corner[3] = {{0, 0, 0}, {0, 0, 2}, {3, 0, 0}};
    PolyhedronParts parts;
    const Polyhedron p = polyhedron_of(triangle_convex(corner, {}, {}), parts);
    EXPECT_EQ(p.faces.size(), 5u);
    EXPECT_EQ(p.edges.size(), 6u);
    EXPECT_EQ(p.faces[0].normal, (Vec3{0, 1, 0}));
    EXPECT_EQ(p.faces[1].normal, (Vec3{0, -1, 0}));
    EXPECT_TRUE(near(p.middle, {1, 0, 2.0 / 3}, 1e-12));
    expect_sound(p);
    for (const HullEdge& edge : p.edges)
        EXPECT_GT(dot(p.faces[edge.left].normal, p.faces[edge.right].normal), -0.5);
}

TEST(Polyhedron, hull_keeps_its_built_topology) {
    Random random(121);
    for (int round = 0; round < 50; round++) {
        const Geometry hull = random_geometry(ShapeKind::hull, random);
        PolyhedronParts parts;
        const Polyhedron p = polyhedron_of(convex_of(transformed_shape(hull, {}), {}), parts);
        EXPECT_EQ(p.vertices.size() + p.faces.size(), p.edges.size() + 2) << "Euler";
        expect_sound(p);
    }
}

}  // namespace
}  // namespace jostle::test
