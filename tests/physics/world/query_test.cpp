// SPDX-License-Identifier: MIT
//
// Queries against brute force over signed distances: every ray is marched, every overlap asked of
// each shape.
#include <gtest/gtest.h>

#include "support/convex_oracle.h"
#include "support/distance_field.h"
#include "support/near.h"
#include "support/random.h"
#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Placement {
    ShapeId id;
    Geometry geometry;
    Transform pose;  // in the world
};

struct RandomScene {
    World world = make_world({.gravity = {}});
    std::vector<Placement> shapes;

    explicit RandomScene(std::uint64_t seed, int bodies = 60) {
        Random random(seed);
        for (int i = 0; i < bodies; i++) {
            const Transform pose{random.vector(6), random.rotation()};
            const BodyType type = i % 3 == 0 ? BodyType::fixed : BodyType::dynamic;
            const BodyId body = must(world.create_body({.type = type, .pose = pose}));
            for (int k = 0; k <= i % 2; k++) {
                const Geometry kinds[] = {
                    Sphere{random.in(0.2, 1)}, Capsule{random.in(0.1, 0.4), random.in(0.2, 1)},
                    Box{{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)}}};
                const Geometry& geometry = kinds[random.below(3)];
                const Transform local{random.vector(0.5), random.rotation()};
                const ShapeId id =
                    must(world.create_shape(body, {.geometry = geometry, .pose = local}));
                shapes.push_back({id, geometry, compose(pose, local)});
            }
        }
        const BodyId ground =
            must(world.create_body({.type = BodyType::fixed, .pose = {{0, -5, 0}, {}}}));
        shapes.push_back(
            {must(world.create_shape(ground, {.geometry = Plane{}})), Plane{}, {{0, -5, 0}, {}}});
    }
};

// Sphere tracing: the distance to the nearest surface is always safe to go. Fraction of the motion,
// or 2.
double march(const std::vector<Placement>& shapes, const Ray& ray, const Placement*& hit) {
    const double far = length(ray.motion);
    const Vec3 direction = ray.motion / far;
    double t = 0;
    for (int step = 0; step < 20000 && t <= far; step++) {
        double nearest = 1e300;
        for (const Placement& s : shapes) {
            const double d = signed_distance(s.geometry, s.pose, ray.origin + direction * t);
            if (d < nearest) nearest = d, hit = &s;
        }
        if (nearest < 1e-10) return t / far;
        t += nearest;
    }
    return 2;
}

TEST(Queries, rays_hit_what_marching_hits) {
    int hits = 0, misses = 0;
    for (std::uint64_t seed = 1; seed <= 4; seed++) {
        const RandomScene scene(seed);
        Random random(seed + 100);
        for (int i = 0; i < 250; i++) {
            Ray ray{random.vector(9), random.vector(12)};
            if (i % 5 == 0)
                ray.motion = {0, -random.in(1, 20), 0};  // along an axis: zero components
            const Placement* expected = nullptr;
            const double fraction = march(scene.shapes, ray, expected);
            const auto hit = must(scene.world.queries().cast_ray(ray));
            if (fraction > 1) {
                // A grazing ray may be seen as a hit at the last moment by one and not the other.
                EXPECT_TRUE(!hit || hit->fraction > 1 - 1e-6);
                misses++;
                continue;
            }
            ASSERT_TRUE(hit.has_value()) << "seed " << seed << " ray " << i;
            hits++;
            EXPECT_NEAR(hit->fraction, fraction, 1e-6);
            EXPECT_TRUE(near(hit->point, ray.origin + ray.motion * hit->fraction, 1e-9));
            EXPECT_NEAR(length(hit->normal), 1, 1e-9);
            EXPECT_LE(dot(hit->normal, ray.motion), 1e-9);
            if (fraction == 0) {
                EXPECT_TRUE(near(hit->normal, normalized(-ray.motion), 1e-9));
                continue;
            }
            EXPECT_EQ(hit->shape, expected->id);
            EXPECT_EQ(must(scene.world.shape(hit->shape)).body, hit->body);
            // The normal is the gradient of the distance.
            const auto at = [&](Vec3 p) {
                return signed_distance(expected->geometry, expected->pose, p);
            };
            const double e = 1e-5;
            const Vec3 p = hit->point + hit->normal * 1e-4;
            const Vec3 gradient{at(p + Vec3{e, 0, 0}) - at(p - Vec3{e, 0, 0}),
                                at(p + Vec3{0, e, 0}) - at(p - Vec3{0, e, 0}),
                                at(p + Vec3{0, 0, e}) - at(p - Vec3{0, 0, e})};
            EXPECT_GT(dot(hit->normal, gradient / (2 * e)), 0.99);
        }
    }
    EXPECT_GT(hits, 300);
    EXPECT_GT(misses, 20);
}

TEST(Queries, ties_go_to_the_lower_id) {
    World world = make_world();
    const BodyId first = add(world, {.position = {0, 0, 0}});
    add(world, {.position = {0, 0, 0}});
    const auto hit = must(world.queries().cast_ray({{-5, 0, 0}, {10, 0, 0}}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, first);
    EXPECT_NEAR(hit->fraction, 0.45, 1e-12);
    EXPECT_TRUE(near(hit->normal, {-1, 0, 0}, 1e-12));
}

TEST(Queries, ray_ends_where_its_motion_ends) {
    World world = make_world();
    add(world, {.geometry = Sphere{0.5}, .position = {10, 0, 0}});
    EXPECT_FALSE(must(world.queries().cast_ray({{0, 0, 0}, {9.49, 0, 0}})));
    EXPECT_TRUE(must(world.queries().cast_ray({{0, 0, 0}, {9.51, 0, 0}})));
}

Aabb bounds_by_support(const Placement& s) {
    const auto reach = [&](Vec3 d) { return support(s.geometry, s.pose, d); };
    return {{-reach({-1, 0, 0}), -reach({0, -1, 0}), -reach({0, 0, -1})},
            {reach({1, 0, 0}), reach({0, 1, 0}), reach({0, 0, 1})}};
}

TEST(Queries, overlap_box_finds_the_bounds_that_overlap) {
    const RandomScene scene(9);
    Random random(10);
    std::size_t found = 0;
    for (int i = 0; i < 300; i++) {
        const Vec3 low = random.vector(7);
        const Aabb box{low, low + Vec3{random.in(0, 3), random.in(0, 3), random.in(0, 3)}};
        std::vector<ShapeId> expected;
        for (const Placement& s : scene.shapes) {
            if (kind_of(s.geometry) == ShapeKind::plane ? box.low.y <= -5
                                                        : overlap(bounds_by_support(s), box))
                expected.push_back(s.id);
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(must(scene.world.queries().overlap_box(box)), expected);
        found += expected.size();
    }
    EXPECT_GT(found, 200u);
}

TEST(Queries, overlap_shape_finds_what_touches) {
    const RandomScene scene(11, 60);
    Random random(12);
    int found = 0;
    for (int i = 0; i < 60; i++) {
        const Geometry kinds[] = {Sphere{random.in(0.2, 1)},
                                  Capsule{random.in(0.1, 0.4), random.in(0.2, 1)},
                                  Box{{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)}}};
        const Geometry& probe = kinds[i % 3];
        const Transform pose{random.vector(5), random.rotation()};
        const auto touched = must(scene.world.queries().overlap_shape(probe, pose));
        EXPECT_TRUE(std::is_sorted(touched.begin(), touched.end()));
        for (const Placement& s : scene.shapes) {
            const double distance = separation(probe, pose, s.geometry, s.pose).distance;
            if (std::fabs(distance) < 1e-4) continue;  // too close to call for the oracle
            const bool reported = std::find(touched.begin(), touched.end(), s.id) != touched.end();
            EXPECT_EQ(reported, distance < 0)
                << "probe " << i << " at distance " << distance << ", kind " << s.geometry.index();
            found += reported;
        }
    }
    EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace jostle::test
