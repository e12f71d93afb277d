// SPDX-License-Identifier: MIT
//
// Hulls of good, bad and hostile points: always a closed convex solid that holds every point, or a
// reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/src/geometry/hull_builder.h"
#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Closed, convex, holds all points within the tolerance, uses only given points.
void expect_sound(const ConvexHull& hull, const std::vector<Vec3>& points, double tolerance) {
    ASSERT_EQ(hull.vertices.size() + hull.faces.size(), hull.edges.size() + 2) << "Euler";
    for (const HullFace& face : hull.faces) {
        ASSERT_GE(face.count, 3u);
        ASSERT_NEAR(length(face.normal), 1, 1e-9);
        for (const Vec3 p : points) ASSERT_LE(dot(face.normal, p), face.offset + tolerance);
        for (const std::uint16_t v : hull.vertices_of(face))
            ASSERT_NEAR(dot(face.normal, hull.vertices[v]), face.offset, 2 * tolerance);
    }
    for (const HullEdge& e : hull.edges) {
        ASSERT_LT(e.left, hull.faces.size());
        ASSERT_LT(e.right, hull.faces.size());
        ASSERT_NE(e.left, e.right);
    }
    for (const Vec3 v : hull.vertices)
        ASSERT_TRUE(std::find(points.begin(), points.end(), v) != points.end());
    ASSERT_GT(hull.volume, 0);
    ASSERT_GT(hull.inner_radius, 0);
}

TEST(HullBuilder, cube_of_a_thousand_points_has_six_faces) {
    std::vector<Vec3> points;
    for (int x = 0; x < 10; x++)
        for (int y = 0; y < 10; y++)
            for (int z = 0; z < 10; z++) points.push_back(Vec3{x / 9.0, y / 9.0, z / 9.0});
    const auto hull = must(build_hull(points));
    EXPECT_EQ(hull->vertices.size(), 8u);
    EXPECT_EQ(hull->faces.size(), 6u);
    EXPECT_EQ(hull->edges.size(), 12u);
    EXPECT_NEAR(hull->volume, 1, 1e-12);
    EXPECT_TRUE(near(hull->center, {0.5, 0.5, 0.5}, 1e-12));
    EXPECT_NEAR(hull->unit_inertia.x.x, 1.0 / 6, 1e-12);
    EXPECT_NEAR(hull->inner_radius, 0.5, 1e-12);
}

// Turned, the same cube's corners are no longer exactly flat: the faces are merged all the same.
TEST(HullBuilder, rotated_cube_has_six_faces) {
    Random random(9);
    for (int round = 0; round < 50; round++) {
        const Quat turn = random.rotation();
        const Vec3 at = random.vector(50);
        std::vector<Vec3> points;
        for (int k = 0; k < 8; k++)
            points.push_back(
                at + rotate(turn, {k & 1 ? 1.0 : -1.0, k & 2 ? 0.5 : -0.5, k & 4 ? 0.25 : -0.25}));
        const auto hull = must(build_hull(points));
        EXPECT_EQ(hull->faces.size(), 6u) << round;
        EXPECT_EQ(hull->vertices.size(), 8u) << round;
        EXPECT_NEAR(hull->volume, 8 * 0.125, 1e-9);
    }
}

TEST(HullBuilder, inertia_of_a_tetrahedron_matches_the_closed_form) {
    // Regular, edge a: volume a^3 / (6 sqrt 2), inertia m a^2 / 20.
    const double a = 2;
    std::vector<Vec3> points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (Vec3& p : points) p = p * (a / (2 * std::sqrt(2.0))) + Vec3{3, -2, 1};
    const auto hull = must(build_hull(points));
    const double volume = a * a * a / (6 * std::sqrt(2.0));
    EXPECT_NEAR(hull->volume, volume, 1e-12);
    EXPECT_TRUE(near(hull->center, {3, -2, 1}, 1e-12));
    for (int k = 0; k < 3; k++) {
        const Vec3 column =
            k == 0 ? hull->unit_inertia.x : (k == 1 ? hull->unit_inertia.y : hull->unit_inertia.z);
        EXPECT_NEAR(column[k], volume * a * a / 20, 1e-12);
    }
}

// Clouds of many kinds: in balls, on spheres, on grids, in near-planes, with duplicates, tiny,
// huge.
TEST(HullBuilder, contains_every_point_of_ten_thousand_random_clouds) {
    Random random(4);
    int built = 0, refused = 0;
    for (int round = 0; round < 10000 && !HasFatalFailure(); round++) {
        std::vector<Vec3> points;
        const auto count = 4 + random.below(60);
        const double scale = std::pow(10.0, random.in(-2.5, 3));
        const auto style = random.below(7);
        const Quat turn = random.rotation();
        for (std::uint64_t i = 0; i < count; i++) {
            Vec3 p = random.vector(1);
            if (style == 1) p = random.direction();
            if (style == 2) p = {std::floor(3 * p.x), std::floor(3 * p.y), std::floor(3 * p.z)};
            if (style == 3) p.y *= 1e-4;
            if (style == 4) p.y *= 1e-9;
            if (style == 5 && i % 3 == 0 && i > 0) p = points[random.below(i)];
            if (style == 6) p = {p.x, p.y > 0 ? 1.0 : -1.0, p.z};
            points.push_back(style == 5 && i % 3 == 0 && i > 0 ? p : rotate(turn, p) * scale);
        }
        const auto hull = build_hull(points);
        if (!hull.ok()) {
            refused++;
            EXPECT_NE(hull.error().message.find("hull"), std::string::npos);
            EXPECT_TRUE(style == 2 || style == 4 || style == 3 || scale < 0.01 || style == 6 ||
                        count < 8)
                << "style " << style << " scale " << scale << ": " << hull.error().message;
            continue;
        }
        built++;
        SCOPED_TRACE(testing::Message() << "round " << round << " style " << style);
        expect_sound(**hull, points, 3e-6 * 4 * scale);
    }
    EXPECT_GT(built, 8000);
    EXPECT_GT(refused, 100);
}

TEST(HullBuilder, errors_name_the_problem_and_the_remedy) {
    const auto refused = [](const std::vector<Vec3>& points, const char* word) {
        const auto hull = build_hull(points);
        ASSERT_FALSE(hull.ok()) << word;
        EXPECT_NE(hull.error().message.find(word), std::string::npos) << hull.error().message;
    };
    refused({}, "at least 4");
    refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "at least 4");
    refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, "plane");
    refused({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, "plane");
    refused({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, "within");
    refused({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}, {0, 0, 1}}, "points[2]");
    refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e9}}, "points[3]");
    std::vector<Vec3> ball;
    Random random(2);
    for (int i = 0; i < 2000; i++) ball.push_back(random.direction());
    refused(ball, "simplify");
    std::vector<Vec3> disc;
    for (int i = 0; i < 100; i++)
        for (const double y : {0.0, 1.0})
            disc.push_back({std::cos(i * pi / 50), y, std::sin(i * pi / 50)});
    refused(disc, "corners");
    refused(std::vector<Vec3>(max_hull_points + 1), "at most");
}

// Vertices and faces as a forged saved world may contain them.
TEST(HullBuilder, rejects_forged_faces) {
    const std::vector<std::vector<std::uint16_t>> tetrahedron = {
        {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const auto corners = [](double size) {
        return std::vector<Vec3>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    };
    EXPECT_TRUE(assemble_hull(corners(1), tetrahedron).ok());
    for (const double size : {1e160, 1e300, 1e-170, 0.0})
        EXPECT_FALSE(assemble_hull(corners(size), tetrahedron).ok()) << size;
    // Two triangles and a bent quadrilateral close a surface of three faces.
    EXPECT_FALSE(assemble_hull(corners(1), {{0, 1, 2}, {0, 2, 3}, {3, 2, 1, 0}}).ok());
}

TEST(HullBuilder, same_points_in_any_order_make_the_same_hull) {
    Random random(6);
    std::vector<Vec3> points;
    for (int i = 0; i < 40; i++) points.push_back(random.vector(1));
    const auto first = must(build_hull(points));
    for (int round = 0; round < 10; round++) {
        for (std::size_t i = points.size(); i > 1; i--)
            std::swap(points[i - 1], points[random.below(i)]);
        EXPECT_EQ(must(build_hull(points))->content_hash, first->content_hash);
    }
}

}  // namespace
}  // namespace jostle::test
