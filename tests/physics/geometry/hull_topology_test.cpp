// SPDX-License-Identifier: MIT
//
// Triangulated hulls of integer points: closed, and no point is outside, at any size of numbers.
#include "physics/src/geometry/hull_topology.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

__extension__ typedef __int128 Wide;

// Six times the volume of the face and the point: positive when it is outside.
Wide height(const std::vector<GridPoint>& points, const HullTriangle& face, const GridPoint& p) {
    const auto from = [&](std::uint32_t k) {
        const GridPoint &o = points[face[0]], &q = points[k];
        return GridPoint{q.x - o.x, q.y - o.y, q.z - o.z};
    };
    const GridPoint u = from(face[1]), v = from(face[2]);
    const GridPoint w{p.x - points[face[0]].x, p.y - points[face[0]].y, p.z - points[face[0]].z};
    return (Wide(u.y) * v.z - Wide(u.z) * v.y) * w.x + (Wide(u.z) * v.x - Wide(u.x) * v.z) * w.y +
           (Wide(u.x) * v.y - Wide(u.y) * v.x) * w.z;
}

// Every side of a face is the side of one other, run through the other way round.
void expect_closed(const std::vector<HullTriangle>& faces) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const HullTriangle& face : faces)
        for (std::size_t k = 0; k < 3; k++) sides[{face[k], face[(k + 1) % 3]}]++;
    for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
}

void expect_hull(const std::vector<GridPoint>& points, const std::vector<HullTriangle>& faces) {
    expect_closed(faces);
    for (const HullTriangle& face : faces)
        for (const GridPoint& p : points) ASSERT_FALSE(height(points, face, p) > 0);
}

TEST(HullTopology, a_cube_with_a_point_in_it_has_twelve_triangles_on_eight_points) {
    std::vector<GridPoint> points{{1, 1, 1}};
    for (int k = 0; k < 8; k++) points.push_back({2 * (k & 1), k & 2, (k & 4) / 2});
    const auto faces = hull_triangles(points);
    ASSERT_TRUE(faces);
    EXPECT_EQ(faces->size(), 12u);
    std::set<std::uint32_t> used;
    for (const HullTriangle& face : *faces) used.insert(face.begin(), face.end());
    EXPECT_EQ(used.size(), 8u);
    EXPECT_EQ(used.count(0), 0u);
    expect_hull(points, *faces);
}

TEST(HullTopology, rejects_degenerate_point_sets) {
    EXPECT_FALSE(hull_triangles(std::vector<GridPoint>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    std::vector<GridPoint> plane, line;
    for (std::int64_t x = 0; x < 5; x++) {
        for (std::int64_t y = 0; y < 5; y++) plane.push_back({x, y, 3 * x - 2 * y});
        line.push_back({x, 2 * x, -x});
    }
    EXPECT_FALSE(hull_triangles(plane));
    EXPECT_FALSE(hull_triangles(line));
    plane.push_back({0, 0, 1});
    EXPECT_TRUE(hull_triangles(plane)) << "one unit off the plane is enough";
}

// At the far ends of the range products need 95 bits: one wrong sign would leave a point outside.
TEST(HullTopology, is_exact_at_coordinates_of_a_billion) {
    Random random(61);
    constexpr std::int64_t most = std::int64_t{1} << 30;
    for (int round = 0; round < 100; round++) {
        std::set<GridPoint> distinct;
        while (distinct.size() < 30) {
            const auto coordinate = [&] {
                return static_cast<std::int64_t>(random.below(2 * most + 1)) - most;
            };
            GridPoint p{coordinate(), coordinate(), coordinate()};
            if (round % 2 == 0)
                p.z = p.x / 2 + p.y / 2 + static_cast<std::int64_t>(random.below(3));
            if (p.z < -most || p.z > most) continue;
            distinct.insert(p);
        }
        const std::vector<GridPoint> points(distinct.begin(), distinct.end());
        const auto faces = hull_triangles(points);
        ASSERT_TRUE(faces);
        expect_hull(points, *faces);
    }
}

}  // namespace
}  // namespace jostle::test
