// SPDX-License-Identifier: MIT
//
// Outlines in the plane touch in one point or two, all of them in the plane.
#include "physics/src/collision/narrowphase/collide_pairs.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Standing {
    Geometry geometry;
    Vec3 position;
    double angle = 0;  // rad, about z
    TransformedShape transformed_shape() const {
        return physics::transformed_shape(geometry, {position, from_axis_angle({0, 0, 1}, angle)});
    }
};
Manifold between(const Standing& a, const Standing& b, double margin = 0.02) {
    PairCache cache;
    return collide_planar(a.transformed_shape(), b.transformed_shape(), margin, cache);
}

// A millimetre deep, half of it over the border: from the corner to the end of what lies below.
TEST(CollidePlanar, box_on_box_has_both_ends_of_the_shared_edge) {
    const Manifold m = between({Box{}, {}}, {Box{}, {0.5, 0.999, 0}});
    ASSERT_EQ(m.count, 2);
    EXPECT_TRUE(near(m.normal, {0, 1, 0}, 1e-12));
    EXPECT_NEAR(m.point[0].x + m.point[1].x, 0.5, 1e-12);
    EXPECT_NEAR(absolute(m.point[0].x - m.point[1].x), 0.5, 1e-12);
    for (int k = 0; k < 2; k++) {
        EXPECT_NEAR(m.gap[k], -0.001, 1e-12);
        EXPECT_NEAR(m.point[k].y, 0.4995, 1e-12);
    }
}

TEST(CollidePlanar, round_shapes_touch_at_one_point) {
    const Manifold discs = between({Sphere{0.5}, {}}, {Sphere{1}, {0.9, 1.2, 0}});
    ASSERT_EQ(discs.count, 1);
    EXPECT_NEAR(discs.gap[0], 0, 1e-12);
    EXPECT_TRUE(near(discs.normal, {0.6, 0.8, 0}, 1e-12));
    EXPECT_TRUE(near(discs.point[0], {0.3, 0.4, 0}, 1e-12));
    // A disc over the corner of a box: the corner is what is nearest.
    const Manifold corner = between({Box{}, {}}, {Sphere{0.5}, {0.8, 0.9, 0}});
    ASSERT_EQ(corner.count, 1);
    EXPECT_TRUE(near(corner.normal, {0.6, 0.8, 0}, 1e-9));
    EXPECT_NEAR(corner.gap[0], 0, 1e-9);
}

TEST(CollidePlanar, capsule_lying_on_a_plane_has_two_points_and_standing_has_one) {
    const Manifold lying = between({Plane{}, {}}, {Capsule{0.2, 1}, {5, 0.19, 0}, pi / 2});
    EXPECT_EQ(lying.count, 2);
    EXPECT_NEAR(lying.gap[0], -0.01, 1e-12);
    const Manifold standing = between({Capsule{0.2, 1}, {5, 1.19, 0}}, {Plane{}, {}});
    ASSERT_EQ(standing.count, 1);
    EXPECT_TRUE(near(standing.normal, {0, -1, 0}, 1e-12)) << "from a, which is above";
}

TEST(CollidePlanar, separated_shapes_report_a_lower_bound_of_the_distance) {
    const Manifold m = between({Box{}, {}}, {Box{}, {3, 0, 0}});
    EXPECT_EQ(m.count, 0);
    EXPECT_NEAR(m.distance, 2, 1e-12);
    EXPECT_TRUE(near(m.normal, {1, 0, 0}, 1e-12));
}

// Random pairs against a walk around both borders. A corner that lies beside a side by a hair
// counts as over it, which is seen from half a metre: a millimetre.
TEST(CollidePlanar, separated_boxes_report_the_gap_of_their_nearest_points) {
    Random random(91);
    int met = 0;
    for (int round = 0; round < 500; round++) {
        const Vec3 ha{random.in(0.2, 1), random.in(0.2, 1), 1},
            hb{random.in(0.2, 1), random.in(0.2, 1), 1};
        const Standing a{Box{ha}, {}, random.in(0, 6)};
        const Standing b{Box{hb}, {random.in(-2, 2), random.in(-2, 2), 0}, random.in(0, 6)};
        const Manifold m = between(a, b, 10);
        double least = 1e300;
        const auto corner = [](const Standing& s, Vec3 half, int k) {
            const Vec3 local{k == 0 || k == 3 ? -half.x : half.x, k < 2 ? -half.y : half.y, 0};
            return s.position + s.transformed_shape().axes * local;
        };
        const auto look = [&](const Standing& s, Vec3 hs, const Standing& t, Vec3 ht) {
            for (int k = 0; k < 4; k++)
                for (int side = 0; side < 4; side++) {
                    const Vec3 p = corner(s, hs, k), from = corner(t, ht, side);
                    const Vec3 d = corner(t, ht, (side + 1) % 4) - from;
                    const double u = clamp(dot(p - from, d) / dot(d, d), 0, 1);
                    least = minimum(least, length(p - from - d * u));
                }
        };
        look(a, ha, b, hb);
        look(b, hb, a, ha);
        ASSERT_GT(m.count, 0);
        for (int k = 0; k < m.count; k++) EXPECT_EQ(m.point[k].z, 0);
        if (m.distance <= 0) continue;
        met++;
        EXPECT_NEAR(m.distance, least, 1e-3) << round;
    }
    EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace jostle::test
