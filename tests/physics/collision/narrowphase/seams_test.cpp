// SPDX-License-Identifier: MIT
//
// Contacts at the seams of a floor of several pieces: which are covered by a neighbour, and which
// act.
#include <gtest/gtest.h>

#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/seams.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TransformedShape at(const Geometry& geometry, Vec3 position) {
    return transformed_shape(geometry, {position, {}});
}

// The manifold of a shape and one of two neighbouring pieces.
Manifold with_neighbour(const TransformedShape& shape, const TransformedShape& piece,
                        const TransformedShape& neighbour) {
    constexpr double margin = 0.05;
    PairCache cache;
    Manifold m = collide(shape, piece, margin, cache);
    apply_seams(m, shape, piece, {.of_a = {}, .of_b = {neighbour}}, margin);
    return m;
}

const Geometry tile = Box{{1, 0.5, 1}};
const TransformedShape left = at(tile, {-1, -0.5, 0}), right = at(tile, {1, -0.5, 0});

// The box rests on the left tile 0.1 mm deep; its front side is 0.05 mm over the right one.
TEST(Seams, box_does_not_meet_the_side_of_the_next_tile) {
    const Geometry box = Box{{0.3, 0.3, 0.3}};
    const TransformedShape shape = at(box, {-0.3 + 5e-5, 0.3 - 1e-4, 0.1});
    PairCache cache;
    EXPECT_NEAR(collide(shape, right, 0.05, cache).normal.x, 1, 1e-9);
    const Manifold m = with_neighbour(shape, right, left);
    EXPECT_TRUE(m.count == 0 || near(m.normal, {0, -1, 0}, 1e-9));
    const Manifold resting = with_neighbour(shape, left, right);
    EXPECT_EQ(resting.count, 4);
    EXPECT_TRUE(near(resting.normal, {0, -1, 0}, 1e-9));
}

TEST(Seams, ball_does_not_meet_the_edge_of_the_next_tile) {
    const Geometry ball = Sphere{0.2};
    const TransformedShape shape = at(ball, {-0.04, 0.2, 0.1});
    PairCache cache;
    EXPECT_EQ(collide(shape, right, 0.05, cache).count, 1);
    EXPECT_EQ(with_neighbour(shape, right, left).count, 0);
    EXPECT_EQ(with_neighbour(shape, left, right).count, 1);
}

// 2 mm are a step, 0.1 mm are not.
TEST(Seams, edge_of_a_higher_tile_acts) {
    const Geometry ball = Sphere{0.2};
    const TransformedShape shape = at(ball, {-0.04, 0.2, 0.1});
    EXPECT_EQ(with_neighbour(shape, at(tile, {1, -0.5 + 2e-3, 0}), left).count, 1);
    EXPECT_EQ(with_neighbour(shape, at(tile, {1, -0.5 + 1e-4, 0}), left).count, 0);
}

TEST(Seams, wall_on_a_tile_acts) {
    const Geometry box = Box{{0.3, 0.3, 0.3}}, wall = Box{{0.1, 0.5, 1}};
    const TransformedShape shape = at(box, {-0.3, 0.3, 0});
    const Manifold m = with_neighbour(shape, at(wall, {0.1, 0.5, 0}), left);
    EXPECT_EQ(m.count, 4);
    EXPECT_NEAR(m.normal.x, 1, 1e-9);
}

TEST(Seams, children_of_a_compound_are_neighbours) {
    const Geometry ball = Sphere{0.2};
    const Geometry floor =
        Compound{must(build_compound({{tile, {{-1, -0.5, 0}, {}}}, {tile, {{1, -0.5, 0}, {}}}}))};
    std::vector<ChildManifold> parts;
    EXPECT_TRUE(collide_composite(at(ball, {-0.04, 0.2, 0.1}), at(floor, {}), 0.05, parts));
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_TRUE(near(parts[0].manifold.normal, {0, -1, 0}, 1e-9));
}

// The impact of a ball with a tile at a point of its edge.
TEST(Seams, impact_with_the_edge_of_the_next_tile_is_covered) {
    const Geometry ball = Sphere{0.2};
    const TransformedShape shape = at(ball, {-0.02, 0.2, 0.1});
    const Vec3 edge{0, 0, 0.1}, n = normalized(shape.position - edge);
    EXPECT_TRUE(is_covered(right, shape, edge, n, {left}, 2e-3));
    EXPECT_FALSE(is_covered(right, shape, edge, n, {}, 2e-3));
    EXPECT_FALSE(is_covered(left, shape, {-0.02, 0, 0.1}, {0, 1, 0}, {right}, 2e-3));
}

}  // namespace
}  // namespace jostle::test
