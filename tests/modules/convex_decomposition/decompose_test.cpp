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

TEST(Decompose, rejects_out_of_range_options) {
    const Solid solid = cube();
    for (const Options& wrong :
         {Options{.hulls_max = 0}, {.max_volume_error = -1}, {.planes_per_axis = 0}})
        EXPECT_FALSE(decompose(solid.vertices, solid.indices, wrong).ok());
}

}  // namespace
}  // namespace jostle::test
