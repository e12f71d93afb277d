// SPDX-License-Identifier: MIT
//
// Meshes that are solids, and errors of meshes that are not.
#include "modules/convex_decomposition/src/closed_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/modules/convex_decomposition/solids.h"

namespace jostle::test {
namespace {

using namespace physics;
using namespace modules::convex_decomposition;

TEST(ClosedMesh, computes_the_volume_for_both_windings) {
    Solid solid = l_shape();
    EXPECT_NEAR(make_closed_mesh(solid.vertices, solid.indices)->volume, 3, 1e-12);
    for (std::size_t k = 0; k < solid.indices.size(); k += 3)
        std::swap(solid.indices[k], solid.indices[k + 1]);
    EXPECT_NEAR(make_closed_mesh(solid.vertices, solid.indices)->volume, 3, 1e-12);
}

TEST(ClosedMesh, classifies_points_and_computes_their_distance) {
    const Solid solid = l_shape();
    const ClosedMesh mesh = *make_closed_mesh(solid.vertices, solid.indices);
    EXPECT_TRUE(is_inside(mesh.triangles, {0.5, 1.5, 0.5}));
    EXPECT_FALSE(is_inside(mesh.triangles, {1.5, 1.5, 0.5})) << "in the notch of the L";
    EXPECT_NEAR(distance_to_surface(mesh.triangles, {1.5, 1.3, 0.5}), 0.3, 1e-12);
    EXPECT_NEAR(distance_to_surface(mesh.triangles, {3, 2, 0.5}), std::sqrt(2), 1e-12);
}

TEST(ClosedMesh, rejects_open_and_degenerate_meshes) {
    const auto error_of = [](const Solid& solid) {
        const auto mesh = make_closed_mesh(solid.vertices, solid.indices);
        return mesh.ok() ? std::string() : mesh.error().message;
    };
    Solid open = cube();
    open.indices.resize(open.indices.size() - 3);
    EXPECT_THAT(error_of(open), testing::HasSubstr("does not have a triangle on each side"));
    Solid flat = cube();
    for (Vec3& p : flat.vertices) p.z = 0;
    EXPECT_THAT(error_of(flat), testing::HasSubstr("no volume"));
    Solid wrong = cube();
    wrong.indices[4] = 99;
    EXPECT_EQ(error_of(wrong), "indices[4] is 99; there are 8 vertices");
    Solid far = cube();
    far.vertices[2].x = std::nan("");
    EXPECT_EQ(error_of(far), "vertices[2] is out of range; it must be within 1e5 m");
}

}  // namespace
}  // namespace jostle::test
