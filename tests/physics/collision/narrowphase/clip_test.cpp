// SPDX-License-Identifier: MIT
//
// Which part of a shape looks along a direction, and the points where two of them lie on each
// other.
#include "physics/src/collision/narrowphase/clip.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/placed_convex.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

Feature feature_of(const Geometry& geometry, Vec3 direction) {
    return feature_along(at(geometry, {}), direction);
}

TEST(Clip, feature_of_box_is_face_of_rod_is_edge_of_ball_is_point) {
    const Feature top = feature_of(Box{{1, 2, 3}}, {0.3, 0.9, 0.2});
    ASSERT_EQ(top.count, 4);
    EXPECT_EQ(top.normal, (Vec3{0, 1, 0}));
    for (int k = 0; k < 4; k++) EXPECT_EQ(top.corner[k].y, 2);
    EXPECT_EQ(feature_of(Capsule{0.1, 2}, {1, 0.1, 0}).count, 2);
    EXPECT_EQ(feature_of(Sphere{1}, {1, 0, 0}).count, 1);
}

// A cylinder shows its end when one looks at it more from above than from the side: eight corners
// stand for the rim. A cone's side leans by its own slope.
TEST(Clip, feature_of_round_solid_is_end_cap_or_side_line) {
    const Feature end = feature_of(Cylinder{2, 1}, {0.6, -0.8, 0});
    EXPECT_EQ(end.count, 8);
    EXPECT_EQ(end.normal, (Vec3{0, -1, 0}));
    EXPECT_NEAR(length(Vec3{end.corner[3].x, 0, end.corner[3].z}), 2, 1e-12);
    EXPECT_TRUE(near(end.corner[0], {2, -1, 0}, 1e-12)) << "one is where it looks along";
    const Feature side = feature_of(Cylinder{2, 1}, {0.8, -0.6, 0});
    ASSERT_EQ(side.count, 2);
    EXPECT_TRUE(near(side.corner[0], {2, -1, 0}, 1e-12));
    EXPECT_TRUE(near(side.corner[1], {2, 1, 0}, 1e-12));
    const Feature slope = feature_of(Cone{3, 2}, {1, 0, 0});
    ASSERT_EQ(slope.count, 2);
    EXPECT_TRUE(near(slope.normal, {0.8, 0.6, 0}, 1e-12));
    EXPECT_TRUE(near(slope.corner[1], {0, 2, 0}, 1e-12));
}

// Clipping retains what is inside of corners in this order. The other order loses all points.
TEST(Clip, corners_of_end_caps_run_counter_clockwise_seen_from_outside) {
    for (const double side : {-1.0, 1.0}) {
        const Feature cap = feature_of(Cylinder{2, 1}, {0.1, side, 0.2});
        for (int k = 0; k < 8; k++) {
            const Vec3 p = cap.corner[k], q = cap.corner[(k + 1) % 8];
            EXPECT_GT(dot(cross(p, q), cap.normal), 0) << side;
        }
    }
    const Feature base = feature_of(Cone{3, 2}, {0, -1, 0});
    EXPECT_GT(dot(cross(base.corner[0], base.corner[1]), base.normal), 0);
}

// The corner nearest to the lower cap's rim and its neighbours are cut where the rims cross.
TEST(Clip, equal_discs_on_each_other_have_eight_points_or_more) {
    const Geometry can = Cylinder{0.5, 0.5};
    for (const double aside : {0.0, 0.1}) {
        const Convex a = at(can, {}), b = at(can, {aside, 1, 0});
        const ContactPoints points =
            contact_points(a, b, {{0, 1, 0}, 0, {aside, 0.5, 0}, {aside, 0.5, 0}}, 0.01);
        EXPECT_GE(points.count, 8) << aside;
        EXPECT_EQ(manifold_of(points, {0, 1, 0}, 0.5).count, 4) << aside;
    }
}

// A box of 1 m stands a millimetre deep on the edge of a table, a quarter of it over the border.
TEST(Clip, points_lie_on_both_faces) {
    const Geometry table = Box{{1, 0.5, 1}}, box = Box{};
    const Convex a = at(table, {}), b = at(box, {0.75, 0.999, 0});
    const ContactPoints points =
        contact_points(a, b, {{0, 1, 0}, -0.001, {0.5, 0.5, 0}, {0.5, 0.499, 0}}, 0.01);
    ASSERT_EQ(points.count, 4);
    double least = 9, most = -9;
    for (int k = 0; k < 4; k++) {
        EXPECT_NEAR(points.gap[k], -0.001, 1e-12);
        EXPECT_NEAR(points.point[k].y, 0.4995, 1e-12) << "half way between the surfaces";
        EXPECT_NEAR(absolute(points.point[k].z), 0.5, 1e-12);
        least = minimum(least, points.point[k].x);
        most = maximum(most, points.point[k].x);
    }
    EXPECT_NEAR(least, 0.25, 1e-12);
    EXPECT_NEAR(most, 1, 1e-12) << "the table ends there";
}

// Turned by 45 degrees on a large face all four corners count, on a face as large as its own the
// eight where their sides cross.
TEST(Clip, rotated_box_on_equal_box_has_eight_points_and_a_manifold_of_four) {
    const Geometry box = Box{};
    const Convex a = at(box, {}), b = at(box, {0, 1, 0}, from_axis_angle({0, 1, 0}, pi / 4));
    const ContactPoints points =
        contact_points(a, b, {{0, 1, 0}, 0, {0, 0.5, 0}, {0, 0.5, 0}}, 0.01);
    EXPECT_EQ(points.count, 8);
    const Manifold manifold = manifold_of(points, {0, 1, 0}, 1);
    EXPECT_EQ(manifold.count, 4);
    EXPECT_NEAR(manifold.distance, 0, 1e-12);
}

TEST(Clip, points_beyond_the_margin_are_dropped) {
    const Geometry floor = Box{{5, 0.5, 5}}, box = Box{};
    const Convex a = at(floor, {}), b = at(box, {0, 1.02, 0}, from_axis_angle({0, 0, 1}, 0.02));
    // The corner below is 1 cm higher, the one opposite 3 cm.
    const Vec3 lowest = support(b, {0, -1, 0});
    const Witness witness{{0, 1, 0}, lowest.y - 0.5, {lowest.x, 0.5, 0}, lowest};
    EXPECT_EQ(contact_points(a, b, witness, 0.015).count, 2);
    EXPECT_EQ(contact_points(a, b, witness, 0.04).count, 4);
}

TEST(Clip, points_outside_the_face_are_dropped) {
    const Geometry floor = Box{{1, 0.5, 1}}, box = Box{};
    EXPECT_EQ(points_over_face(at(floor, {}), at(box, {0, 1, 0}), {0, 1, 0}, 0.01).count, 4);
    EXPECT_EQ(points_over_face(at(floor, {}), at(box, {1.6, 1, 0}), {0, 1, 0}, 0.01).count, 0);
}

}  // namespace
}  // namespace jostle::test
