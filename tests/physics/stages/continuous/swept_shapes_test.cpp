// SPDX-License-Identifier: MIT
//
// Which shapes of a body with many are near another shape.
#include "physics/src/stages/continuous/swept_shapes.h"

#include <gtest/gtest.h>

#include "physics/src/stages/continuous/toi_motion.h"
#include "tests/physics/stages/continuous/toi_scene.h"

namespace jostle::test {
namespace {
using namespace physics;

// Spheres of 0.1 m, one every metre along x, and a ball 0.5 m above sphere 7.
class SweptShapesOf {
public:
    explicit SweptShapesOf(int spheres) : ball_(scene_.ball(0)) {
        const BodyId row = add(scene_.world, {.geometry = Sphere{0.1}, .position = {0, 5, 0}});
        for (int k = 1; k < spheres; k++)
            must(scene_.world.create_shape(
                row, {.geometry = Sphere{0.1}, .pose = {{static_cast<double>(k), 0, 0}, {}}}));
        row_ = row.index;
    }
    std::vector<std::uint32_t> near_ball_above(double x) {
        const WorldState& world = state_of(scene_.world);
        ToiState& state = scene_.begin();
        ToiBody& t = state.bodies[scene_.moving(row_, 0)];
        const Vec3 first =
            transformed_shape(world.shapes.shapes[world.bodies.cold[row_].first_shape],
                              warm_of(world, row_))
                .position;
        const Sweep path{0, first + Vec3{x, 0.5, 0}, {}, {0, -0.5, 0}, {}};
        std::vector<std::uint32_t> found;
        for_each_shape_near(world, t, swept_shape(world, ball_, path), 1e-4,
                            [&](std::uint32_t shape) { found.push_back(shape); });
        return found;
    }
    std::uint32_t first() const { return state_of(scene_.world).bodies.cold[row_].first_shape; }

private:
    mutable ToiScene scene_;
    std::uint32_t ball_, row_ = 0;
};

TEST(SweptShapes, finds_the_shapes_near_the_path_of_another) {
    SweptShapesOf row(20);
    EXPECT_EQ(row.near_ball_above(7), (std::vector<std::uint32_t>{row.first() + 7}));
}

TEST(SweptShapes, visits_all_shapes_of_a_body_with_few) {
    SweptShapesOf row(3);
    EXPECT_EQ(row.near_ball_above(7).size(), 3u);
}

}  // namespace
}  // namespace jostle::test
