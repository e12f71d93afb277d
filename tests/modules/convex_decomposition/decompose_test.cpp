// SPDX-License-Identifier: MIT
//
// Decomposition of solids: number of hulls and volume error.
#include "jostle/modules/convex_decomposition.h"

#include <gtest/gtest.h>

#include <string>

#include "jostle/physics/world.h"
#include "tests/modules/convex_decomposition/solids.h"

namespace jostle::test {
namespace {

using namespace physics;
using namespace modules::convex_decomposition;

Decomposition of(const Solid& solid, const Options& options = {}) {
    return decompose(solid.vertices, solid.indices, options).value();
}

TEST(Decompose, keeps_a_convex_mesh_as_one_hull) {
    const Decomposition one = of(cube());
    ASSERT_EQ(one.parts.size(), 1u);
    EXPECT_NEAR(one.max_volume_error, 0, 1e-12);
    EXPECT_NEAR(one.max_distance, 0, 1e-9);
}

TEST(Decompose, splits_an_l_shape_into_two_boxes) {
    const Decomposition two = of(l_shape());
    EXPECT_EQ(two.parts.size(), 2u);
    EXPECT_NEAR(two.max_volume_error, 0, 1e-12);
    double volume = 0;
    for (const auto& part : two.parts) volume += part->volume;
    EXPECT_NEAR(volume, 3, 1e-12);
}

// A ring of 1152 triangles: more hulls are more accurate, and each corner of the ring is in a hull.
TEST(Decompose, improves_a_ring_with_more_hulls) {
    const Solid ring = torus(1, 0.3, 48, 12);
    double previous_error = 1e9;
    for (const int parts : {12, 24, 48}) {
        const Decomposition found = of(ring, {.hulls_max = parts, .max_volume_error = 0.03});
        EXPECT_LE(found.parts.size(), static_cast<std::size_t>(parts));
        EXPECT_LT(found.max_volume_error, previous_error);
        previous_error = found.max_volume_error;
        RecordProperty("excess_" + std::to_string(parts), std::to_string(found.max_volume_error));
        RecordProperty("furthest_" + std::to_string(parts), std::to_string(found.max_distance));
        for (const Vec3 p : ring.vertices) {
            const bool held = std::any_of(found.parts.begin(), found.parts.end(), [&](auto& hull) {
                return std::all_of(hull->faces.begin(), hull->faces.end(), [&](const HullFace& f) {
                    return dot(f.normal, p) <= f.offset + 1e-6;
                });
            });
            ASSERT_TRUE(held);
        }
    }
    EXPECT_LT(previous_error, 0.09);
}

// A peg falls through the hole of the ring, which a single hull would close.
TEST(Decompose, preserves_the_hole_of_a_dynamic_ring) {
    const Decomposition found = of(torus(1, 0.3, 32, 12), {.hulls_max = 24});
    std::vector<ShapeDef> shapes;
    for (const auto& part : found.parts) shapes.push_back({.geometry = Hull{part}});
    World world = std::move(*World::create());
    ASSERT_TRUE(world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).ok());
    const BodyId ring = *world.create_body({.pose = {.position = {0, 0.31, 0}}}, shapes);
    EXPECT_NEAR(world.body(ring)->mass, 1000 * found.mesh_volume * (1 + found.max_volume_error),
                1e-6);
    const BodyId peg =
        *world.create_body({.pose = {.position = {0, 2, 0}}}, {.geometry = Capsule{0.2, 0.3}});
    for (int k = 0; k < 120; k++) ASSERT_TRUE(world.step(1.0 / 60).ok());
    EXPECT_LT(world.body(peg)->pose.position.y, 0.6);
}

// A ball of 1562 corners: a hull has at most 252.
TEST(Decompose, reduces_a_smooth_ball_to_one_hull) {
    const Solid solid = ball(40, 40);
    ASSERT_EQ(solid.vertices.size(), 1562u);
    for (const int hulls : {1, 32, 256}) {
        const Decomposition one = of(solid, {.hulls_max = hulls});
        ASSERT_EQ(one.parts.size(), 1u);
        EXPECT_LE(one.parts[0]->vertices.size(), max_hull_vertices);
        EXPECT_NEAR(one.parts[0]->volume, one.mesh_volume, 0.03 * one.mesh_volume);
        EXPECT_LT(one.max_volume_error, 0.03);
        EXPECT_GT(one.max_volume_error, 0.001);
    }
    const Decomposition fine = of(solid, {.hulls_max = 8, .max_volume_error = 0.005});
    EXPECT_GT(fine.parts.size(), 1u);
    EXPECT_LE(fine.parts.size(), 8u);
}

// The caps have 100 corners; a face of a hull has at most 64.
TEST(Decompose, reduces_a_round_cylinder_to_one_hull) {
    std::vector<std::array<double, 2>> circle;
    std::vector<std::array<std::uint32_t, 3>> cap;
    for (std::uint32_t k = 0; k < 100; k++) {
        circle.push_back({std::cos(2 * pi * k / 100), std::sin(2 * pi * k / 100)});
        if (k >= 2) cap.push_back({0, k - 1, k});
    }
    const Decomposition one = of(prism(circle, cap, 1));
    ASSERT_EQ(one.parts.size(), 1u);
    EXPECT_NEAR(one.parts[0]->volume, pi, 0.03 * pi);
}

TEST(Decompose, rejects_out_of_range_options) {
    const Solid solid = cube();
    for (const Options& wrong :
         {Options{.hulls_max = 0}, {.max_volume_error = -1}, {.planes_per_axis = 0}})
        EXPECT_FALSE(decompose(solid.vertices, solid.indices, wrong).ok());
}

}  // namespace
}  // namespace jostle::test
