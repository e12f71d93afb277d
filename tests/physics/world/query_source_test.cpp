// SPDX-License-Identifier: MIT
//
// Shapes of a world that are asked about where they are not: the answers are those of a world in
// which they are there.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Forty bodies of two shapes each, and a floor; the same shapes, in the same order, in every such
// world, each body elsewhere.
struct ScatteredWorld {
    World world = make_world({.gravity = {}});
    std::vector<ShapePlacement> placements;

    ScatteredWorld(std::uint64_t places, double spread) {
        Random shapes(1), where(places);
        for (int i = 0; i < 40; i++) {
            const Transform pose{where.vector(spread), where.rotation()};
            const BodyId body = must(world.create_body(
                {.type = i % 4 == 0 ? BodyType::static_body : BodyType::dynamic, .pose = pose}));
            const Geometry kinds[] = {
                Sphere{shapes.in(0.2, 1)}, Capsule{0.3, shapes.in(0.2, 1)},
                Box{{shapes.in(0.1, 1), shapes.in(0.1, 1), shapes.in(0.1, 1)}}, Cylinder{0.4, 0.5}};
            for (int k = 0; k < 2; k++) {
                const Transform local{shapes.vector(0.5), shapes.rotation()};
                placements.push_back({must(world.create_shape(
                                          body, {.geometry = kinds[(i + k) % 4], .pose = local})),
                                      compose(pose, local)});
            }
        }
        const Transform ground{{0, -6, 0}, {}};
        const BodyId floor =
            must(world.create_body({.type = BodyType::static_body, .pose = ground}));
        placements.push_back({must(world.create_shape(floor, {.geometry = Plane{}})), ground});
    }
};

TEST(QuerySource, shapes_at_other_poses_are_hit_there) {
    const ScatteredWorld now(2, 6), then(3, 6);
    const Queries live = must(now.world.queries().with_shapes_at(then.placements));
    const Queries copy = must(now.world.query_frame().with_shapes_at(then.placements));
    const Queries truth = then.world.queries();
    Random random(4);
    int hits = 0;
    for (int i = 0; i < 300; i++) {
        const Ray ray{random.vector(9), random.vector(14)};
        const auto expected = must(truth.cast_ray(ray));
        for (const Queries& asked : {live, copy}) {
            const auto hit = must(asked.cast_ray(ray));
            ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
            if (!hit) continue;
            hits++;
            EXPECT_EQ(hit->shape, expected->shape);
            EXPECT_NEAR(hit->fraction, expected->fraction, 1e-9);
        }
        const ShapeCast cast{Sphere{0.3}, {ray.origin, {}}, ray.motion};
        const auto touch = must(live.cast_shape(cast)),
                   expected_touch = must(truth.cast_shape(cast));
        ASSERT_EQ(touch.has_value(), expected_touch.has_value()) << i;
        if (touch) {
            EXPECT_EQ(touch->shape, expected_touch->shape);
            EXPECT_NEAR(touch->fraction, expected_touch->fraction, 1e-6);
        }
        EXPECT_EQ(must(live.overlap_shape(Sphere{1}, {ray.origin, {}})),
                  must(truth.overlap_shape(Sphere{1}, {ray.origin, {}})));
        EXPECT_NEAR(must(live.closest_point(ray.origin, 30))->distance,
                    must(truth.closest_point(ray.origin, 30))->distance, 1e-9);
    }
    EXPECT_GT(hits, 200);
}

TEST(QuerySource, unlisted_and_destroyed_shapes_are_not_hit) {
    World world = make_world({.gravity = {}});
    const BodyId near_body = add(world, {.position = {2, 0, 0}});
    const BodyId far_body = add(world, {.position = {5, 0, 0}});
    const ShapeId near_shape = world.shapes_of(near_body)[0],
                  far_shape = world.shapes_of(far_body)[0];
    const Ray ray{{0, 0, 0}, {10, 0, 0}};
    const Queries only_far = must(world.queries().with_shapes_at({{far_shape, {{5, 0, 0}, {}}}}));
    EXPECT_EQ(must(only_far.cast_ray(ray))->body, far_body);
    must(world.destroy_body(near_body));
    const Queries both = must(world.queries().with_shapes_at(
        {{far_shape, {{5, 0, 0}, {}}}, {near_shape, {{2, 0, 0}, {}}}, {ShapeId{}, {}}}));
    EXPECT_EQ(must(both.cast_ray(ray))->body, far_body);
    EXPECT_FALSE(must(both.cast_ray(ray, {.ignore = far_body})));
}

TEST(QuerySource, rejects_an_invalid_pose_by_index) {
    World world = make_world();
    const ShapeId shape = world.shapes_of(add(world, {}))[0];
    const auto refused = world.queries().with_shapes_at(
        {{shape, {}}, {shape, {{0, std::numeric_limits<double>::quiet_NaN(), 0}, {}}}});
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("shapes[1].pose"), std::string::npos)
        << refused.error().message;
}

}  // namespace
}  // namespace jostle::test
