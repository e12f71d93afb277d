// SPDX-License-Identifier: MIT
#include "jostle/client/subdivision.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::client {
namespace {

double distance(const PointPosition& a, const PointPosition& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// A point of the unit circle.
PointPosition on_circle(double turns) {
    const double angle = 2 * std::acos(-1.0) * turns;
    return {std::cos(angle), std::sin(angle), 0};
}

TEST(Subdivision, strand_passes_through_its_points_and_follows_a_circle) {
    std::vector<PointPosition> points;
    for (int k = 0; k <= 16; k++) points.push_back(on_circle(k / 32.0));
    const auto smooth = subdivide_strand(points, 4);
    ASSERT_EQ(smooth.size(), 65u);
    for (std::size_t k = 0; k < points.size(); k++)
        EXPECT_LT(distance(smooth[4 * k], points[k]), 1e-12);
    // The chords of 16 segments of a half circle are off by 5 mm, the spline by 0.1 mm.
    for (std::size_t k = 4; k < 61; k++) EXPECT_NEAR(distance(smooth[k], {}), 1, 1e-4) << k;
}

TEST(Subdivision, straight_strand_stays_straight_up_to_its_ends) {
    const std::vector<PointPosition> points{{0, 0, 0}, {1, 2, 0}, {2, 4, 0}};
    for (const PointPosition& p : subdivide_strand(points, 5)) EXPECT_NEAR(p[1], 2 * p[0], 1e-12);
    EXPECT_EQ(subdivide_strand(std::span(points).first(1), 5).size(), 1u);
    EXPECT_TRUE(subdivide_strand({}, 5).empty());
}

TEST(Subdivision, grid_follows_a_cylinder) {
    std::vector<PointPosition> points;
    for (int row = 0; row < 5; row++)
        for (int column = 0; column <= 8; column++) {
            PointPosition p = on_circle(column / 16.0);
            p[2] = 0.3 * row;
            points.push_back(p);
        }
    const auto smooth = subdivide_grid(points, 9, 3);
    ASSERT_EQ(smooth.size(), 25u * 13u);
    for (std::size_t k = 0; k < smooth.size(); k++) {
        const std::size_t column = k % 25;
        if (column < 3 || column > 21) continue;  // the surface continues straight at its ends
        EXPECT_NEAR(std::hypot(smooth[k][0], smooth[k][1]), 1, 1.5e-3);
        EXPECT_NEAR(smooth[k][2], 0.1 * static_cast<double>(k / 25), 1e-12);
    }
}

TEST(Subdivision, mesh_of_a_plane_stays_a_plane_with_four_times_the_triangles) {
    TriangleMesh mesh;
    for (int k = 0; k < 9; k++)
        mesh.points.push_back({static_cast<double>(k % 3), 1, static_cast<double>(k / 3)});
    for (const std::uint32_t a : {0u, 1u, 3u, 4u})
        for (const std::uint32_t corner : {a, a + 3, a + 1, a + 1, a + 3, a + 4})
            mesh.triangles.push_back(corner);
    mesh.triangles.insert(mesh.triangles.end(), {0, 1, 99});  // dropped
    const TriangleMesh fine = subdivide_mesh(mesh);
    EXPECT_EQ(fine.triangles.size(), 4u * 24u);
    EXPECT_EQ(fine.points.size(), 9u + 16u);
    for (const PointPosition& p : fine.points) {
        EXPECT_DOUBLE_EQ(p[1], 1);
        EXPECT_TRUE(p[0] >= 0 && p[0] <= 2 && p[2] >= 0 && p[2] <= 2);
    }
    EXPECT_LT(distance(fine.points[4], mesh.points[4]), 1e-12) << "the inner point of a plane";
}

// A point of n neighbours with the weight b each tends to (1 - n x) p + x (sum of neighbours) with
// x = 1 / (3 / (8 b) + n) (Loop): of an octahedron, half of its corner.
TEST(Subdivision, corner_of_an_octahedron_tends_to_half_of_it) {
    TriangleMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                      {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};
    for (int step = 0; step < 6; step++) mesh = subdivide_mesh(mesh);
    EXPECT_EQ(mesh.triangles.size(), 3u * 8 * 4096);
    EXPECT_NEAR(mesh.points[0][0], 0.5, 1e-3);
}

}  // namespace
}  // namespace jostle::client
