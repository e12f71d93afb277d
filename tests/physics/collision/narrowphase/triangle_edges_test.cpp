// SPDX-License-Identifier: MIT
//
// Contact normals at the edges of a triangle: flat ground, a ridge, a valley and a border.
#include "physics/src/collision/narrowphase/triangle_edges.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

constexpr double edge_sine = 1e-4;

// In the plane y = 0, facing up. Edge 0 is along z through the origin; its outside is towards -x.
SurfaceTriangle right_triangle() {
    return {.corner = {{0, 0, -1}, {0, 0, 1}, {2, 0, 0}}};
}

// Whether a normal that leans outwards over edge 0 by this angle may act, if the ground there turns
// by `turn` rad: positive at a ridge.
bool leans(double angle, float half_turn, double side = 1) {
    const SurfaceFolds folds{{half_turn, no_neighbour_fold, no_neighbour_fold}};
    const SinCos lean = sin_cos(angle);
    return may_act(right_triangle(), folds, Vec3{0, 1, 0} * side, side, {0, 0, 0},
                   {-lean.sin, lean.cos * side, 0}, edge_sine);
}

TEST(TriangleEdges, triangle_of_the_tests_faces_up) {
    EXPECT_EQ(normal_of(right_triangle()), (Vec3{0, 1, 0}));
}

TEST(TriangleEdges, normals_between_the_two_faces_of_a_ridge_act) {
    const float ridge =
        static_cast<float>(sin_cos(pi / 8).sin / sin_cos(pi / 8).cos);  // 45 degrees
    EXPECT_TRUE(leans(0, ridge));
    EXPECT_TRUE(leans(0.99 * pi / 4, ridge));
    EXPECT_FALSE(leans(1.01 * pi / 4, ridge));
    EXPECT_FALSE(leans(-0.01, ridge)) << "towards the triangle: its face pushes";
}

TEST(TriangleEdges, flat_edges_and_valleys_allow_the_face_normal_only) {
    for (const float fold : {0.0f, -0.5f}) {
        EXPECT_TRUE(leans(0.5e-4, fold));
        EXPECT_FALSE(leans(0.01, fold));
    }
}

// From below, the ridge is a valley.
TEST(TriangleEdges, folds_are_reversed_behind_a_triangle) {
    EXPECT_FALSE(leans(0.3, 0.4f, -1));
    EXPECT_TRUE(leans(0.3, -0.4f, -1));
    EXPECT_EQ(ridge_of({{0.4f, 0, 0}}, 0, -1), -double{0.4f});
}

TEST(TriangleEdges, borders_allow_half_of_all_directions) {
    EXPECT_TRUE(leans(0.49 * pi, no_neighbour_fold));
    EXPECT_FALSE(leans(0.51 * pi, no_neighbour_fold));
    const SurfaceFolds folds{{0, no_neighbour_fold, 0}};
    EXPECT_TRUE(is_on_border(right_triangle(), folds, {1, 0, 0.5}));
    EXPECT_FALSE(is_on_border(right_triangle(), folds, {0, 0, 0}));
}

}  // namespace
}  // namespace jostle::test
