// SPDX-License-Identifier: MIT
//
// A capsule that lies along an edge touches it at both ends of what they have in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/src/collision/narrowphase/collide.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr Vec3 half{0.3, 0.25, 0.35};
constexpr double r = 0.2, length_of_half = 0.25;

Geometry same_as_hull() {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; k++)
        corners.push_back({(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                           (k & 4) != 0 ? half.z : -half.z});
    return Hull{must(build_hull(corners))};
}

// The capsule's axis runs along the upper edge at +x of a box, turned by `turn` about the direction
// that leans by `lean` from the upper face's normal; they touch at its middle.
Manifold beside_edge(const Geometry& box, double lean, double turn) {
    const Vec3 out{std::sin(lean), std::cos(lean), 0}, side{std::cos(lean), -std::sin(lean), 0};
    const Geometry capsule = Capsule{r, length_of_half};
    const Vec3 axis = Vec3{0, 0, 1} * std::cos(turn) + side * std::sin(turn);
    const TransformedShape a{&box, {}, diagonal({1, 1, 1})};
    const TransformedShape b{
        &capsule, Vec3{half.x, half.y, 0} + out * r, {cross(axis, out), axis, out}};
    PairCache cache;
    return collide(a, b, 0.02, cache);
}

TEST(CollideCapsule, parallel_to_an_edge_has_two_points) {
    for (const Geometry& box : {Geometry{Box{half}}, same_as_hull()})
        for (const double lean : {0.05, 0.1, 0.3, 0.8})
            for (const double turn : {0.0, 0.01, 0.05}) {
                const Manifold m = beside_edge(box, lean, turn);
                SCOPED_TRACE(testing::Message() << "lean " << lean << ", turn " << turn);
                ASSERT_GE(m.count, 2);
                const auto [first, last] = std::minmax_element(
                    m.point, m.point + m.count, [](Vec3 p, Vec3 q) { return p.z < q.z; });
                EXPECT_NEAR(last->z - first->z, 2 * length_of_half, 1e-2);
                // An end is as far away as the edge, or nearer where it reaches over the face.
                const double aside = length_of_half * std::sin(turn);
                const double height = r * std::cos(lean) - aside * std::sin(lean);
                for (int k = 0; k < m.count; k++) {
                    EXPECT_GT(m.gap[k], height - r - 1e-9);
                    EXPECT_LT(m.gap[k], std::hypot(r, aside) - r + 1e-9);
                }
            }
}

// An edge crossed at 45 degrees is met in one point.
TEST(CollideCapsule, crossing_an_edge_has_one_point) {
    for (const Geometry& box : {Geometry{Box{half}}, same_as_hull()})
        EXPECT_EQ(beside_edge(box, 0.6, 0.8).count, 1);
}

// Two capsules, one above the other and turned against it, that overlap by `depth` in the middle.
Manifold crossed(double turn, double depth) {
    const Geometry capsule = Capsule{r, length_of_half};
    const Vec3 axis{std::sin(turn), 0, std::cos(turn)}, up{0, 1, 0};
    const TransformedShape a{&capsule, {}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    const TransformedShape b{&capsule, up * (2 * r - depth), {cross(axis, up), axis, up}};
    PairCache cache;
    return collide(a, b, 0.02, cache);
}

// At both ends, as far apart as they are there, and at two points about the crossing, no more than
// a five-thousandth of the radius further apart than there. On the crossing alone, which runs along
// them with every turn, a capsule in a heap rocked at 1.7 rad/s for seconds; with it and the ends
// one under fifty times its weight shook at 0.1 m/s for as long as one looked.
TEST(CollideCapsule, crossing_another_at_a_small_angle_has_four_points) {
    for (const double turn : {0.05, 0.12, 0.25})
        for (const double depth : {0.0, 0.001, 0.05}) {
            const Manifold m = crossed(turn, depth);
            SCOPED_TRACE(testing::Message() << "turn " << turn << ", depth " << depth);
            ASSERT_EQ(m.count, 4);
            double reach = 0, aside = 0;
            for (int k = 0; k < m.count; k++) {
                const bool middle = std::abs(m.point[k].z) < 0.8 * length_of_half;
                const double along = std::abs(m.point[k].z);
                reach = std::max(reach, along);
                if (middle) aside = std::max(aside, along);
                // The point is midway between s of the one axis and s cos^2 along it of the other.
                const double s = 2 * along / (1 + std::cos(turn) * std::cos(turn));
                EXPECT_NEAR(m.gap[k], std::hypot(2 * r - depth, s * std::sin(turn)) - 2 * r, 1e-9);
                if (middle) {
                    EXPECT_NEAR(m.gap[k], 2e-4 * r - depth, 1e-4 * r);
                }
            }
            EXPECT_NEAR(reach, length_of_half, 0.02);
            EXPECT_NEAR(aside, 2 * r * std::sqrt(2e-4) / std::sin(turn), 0.05 * aside);
        }
    EXPECT_EQ(crossed(0.8, 0.001).count, 1);
}

}  // namespace
}  // namespace jostle::test
