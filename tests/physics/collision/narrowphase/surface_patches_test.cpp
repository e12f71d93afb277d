// SPDX-License-Identifier: MIT
//
// Manifolds from the contact points of single triangles.
#include "physics/src/collision/narrowphase/surface_patches.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr Vec3 patch_corners[3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};

// The points of one triangle, all at the same gap along the normal.
void add_patch(SurfacePatches& patches, Vec3 normal, std::uint32_t triangle, double gap,
               std::initializer_list<Vec3> on_ground) {
    patches.begin();
    for (const Vec3 p : on_ground) patches.put(GapPoint{p + normal * (0.5 * gap), gap});
    patches.close(normal, triangle, patch_corners);
}

std::vector<Manifold> written(SurfacePatches& patches) {
    static const Geometry ground = Plane{};
    std::vector<Manifold> out;
    patches.write(transformed_shape(ground, {.position = {10, 0, 0}}), {0, 2, 0}, out);
    return out;
}

TEST(SurfacePatches, coplanar_triangles_share_a_manifold_and_its_points) {
    SurfacePatches patches(1);
    add_patch(patches, {0, 1, 0}, 4, -0.01, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}});
    add_patch(patches, {0, 1, 0}, 5, -0.01, {{0, 0, 0}, {1, 0, 1}, {0, 0, 1}});
    const std::vector<Manifold> manifolds = written(patches);
    ASSERT_EQ(manifolds.size(), 1u);
    EXPECT_EQ(manifolds[0].count, 4) << "the diagonal counts once";
    // In world space: the surface is at x = 10, the shape 2 m above its origin.
    for (int k = 0; k < 4; k++) {
        EXPECT_GE(manifolds[0].point[k].x, 10);
        EXPECT_DOUBLE_EQ(manifolds[0].point[k].y, 2 - 0.005);
        EXPECT_DOUBLE_EQ(manifolds[0].gap[k], -0.01);
    }
}

TEST(SurfacePatches, slopes_and_steps_have_their_own_manifolds_deepest_first) {
    SurfacePatches patches(1);
    add_patch(patches, {0, 1, 0}, 1, 0.01, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}});
    add_patch(patches, normalized(Vec3{0.2, 1, 0}), 2, -0.02, {{0, 0, 0}, {1, 0, 0}});
    add_patch(patches, {0, 1, 0}, 3, 0.02, {{0, 0.1, 0}});  // ten centimetres higher
    EXPECT_TRUE(patches.any_overlaps());
    const std::vector<Manifold> manifolds = written(patches);
    ASSERT_EQ(manifolds.size(), 3u);
    EXPECT_TRUE(near(manifolds[0].normal, normalized(Vec3{0.2, 1, 0}), 1e-12));
    EXPECT_EQ(manifolds[1].count, 3);
    EXPECT_EQ(manifolds[2].count, 1);
}

TEST(SurfacePatches, points_that_are_not_closed_do_not_count) {
    SurfacePatches patches(1);
    patches.begin();
    patches.put(GapPoint{{5, 5, 5}, -1});
    EXPECT_EQ(patches.smallest_gap(), -1);
    add_patch(patches, {0, 1, 0}, 1, 0.25, {{0, 0, 0}});
    ASSERT_EQ(patches.all().size(), 1u);
    EXPECT_EQ(patches.all()[0].deepest, 0.25);
    EXPECT_FALSE(patches.any_overlaps());
    patches.begin();
    EXPECT_FALSE(patches.close({0, 1, 0}, 2, patch_corners)) << "no points";
    patches.put(GapPoint{{}, 0.5});
    patches.drop_if([](const GapPoint& p) { return p.gap > 0.4; });
    EXPECT_TRUE(patches.current().empty());
    EXPECT_EQ(written(patches).size(), 1u);
}

}  // namespace
}  // namespace jostle::test
