// SPDX-License-Identifier: MIT
//
// Queries against brute force over signed distances: every ray is marched, every overlap asked of
// each shape.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/support/convex_oracle.h"
#include "tests/support/distance_field.h"
#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

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

    static Geometry random_convex(Random& random) {
        std::vector<Vec3> points;
        for (int i = 0; i < 9; i++) points.push_back(random.vector(0.8));
        const Geometry kinds[] = {Sphere{random.in(0.2, 1)},
                                  Capsule{random.in(0.1, 0.4), random.in(0.2, 1)},
                                  Box{{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)}},
                                  Cylinder{random.in(0.1, 0.8), random.in(0.1, 0.8)},
                                  Cone{random.in(0.2, 0.8), random.in(0.2, 0.8)},
                                  Hull{must(build_hull(points))}};
        return kinds[random.below(6)];
    }

    void add_one(BodyType type, const Geometry& geometry, const Transform& pose) {
        const BodyId body = must(world.create_body({.type = type, .pose = pose}));
        shapes.push_back({must(world.create_shape(body, {.geometry = geometry})), geometry, pose});
    }

    explicit RandomScene(std::uint64_t seed, int bodies = 60) {
        Random random(seed);
        for (int i = 0; i < bodies; i++) {
            const Transform pose{random.vector(6), random.rotation()};
            const BodyType type = i % 3 == 0 ? BodyType::static_body : BodyType::dynamic;
            const BodyId body = must(world.create_body({.type = type, .pose = pose}));
            for (int k = 0; k <= i % 2; k++) {
                const Geometry geometry = random_convex(random);
                const Transform local{random.vector(0.5), random.rotation()};
                const ShapeId id =
                    must(world.create_shape(body, {.geometry = geometry, .pose = local}));
                shapes.push_back({id, geometry, compose(pose, local)});
            }
        }
        const Geometry compound = Compound{must(
            build_compound({{random_convex(random), {random.vector(0.5), random.rotation()}},
                            {random_convex(random), {random.vector(0.5), random.rotation()}},
                            {random_convex(random), {random.vector(0.5), random.rotation()}}}))};
        add_one(BodyType::dynamic, compound, {random.vector(5), random.rotation()});
        std::vector<Vec3> vertices;
        for (int i = 0; i < 12; i++) vertices.push_back(random.vector(3));
        add_one(
            BodyType::static_body,
            Mesh{must(build_mesh(vertices,
                                 std::vector<std::array<std::uint32_t, 3>>{
                                     {0, 1, 2}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {9, 10, 11}}))},
            {random.vector(3), random.rotation()});
        HeightGrid grid{.columns = 7, .rows = 5, .spacing_x = 1.2, .spacing_z = 1.5, .heights = {}};
        for (int i = 0; i < 35; i++) grid.heights.push_back(random.in(-1, 1));
        grid.holes.assign(24, 0);
        grid.holes[9] = 1;
        add_one(BodyType::static_body, HeightField{must(build_height_field(grid))},
                {{random.in(-2, 2), -4, random.in(-2, 2)}, random.rotation()});
        const BodyId ground =
            must(world.create_body({.type = BodyType::static_body, .pose = {{0, -5, 0}, {}}}));
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

TEST(Queries, rays_match_ray_marching) {
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

TEST(Queries, ray_ends_at_its_motion) {
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

TEST(Queries, overlap_box_finds_overlapping_bounds) {
    const RandomScene scene(9);
    Random random(10);
    std::size_t found = 0;
    for (int i = 0; i < 300; i++) {
        const Vec3 low = random.vector(7);
        const Aabb box{low, low + Vec3{random.in(0, 3), random.in(0, 3), random.in(0, 3)}};
        std::vector<ShapeId> expected;
        // Bounds of surfaces and compounds are not the tightest.
        std::vector<ShapeId> loose;
        for (const Placement& s : scene.shapes) {
            if (kind_of(s.geometry) > ShapeKind::hull) {
                loose.push_back(s.id);
                continue;
            }
            if (kind_of(s.geometry) == ShapeKind::plane ? box.low.y <= -5
                                                        : overlap(bounds_by_support(s), box))
                expected.push_back(s.id);
        }
        std::sort(expected.begin(), expected.end());
        auto found_ids = must(scene.world.queries().overlap_box(box));
        std::erase_if(found_ids, [&](ShapeId id) {
            return std::find(loose.begin(), loose.end(), id) != loose.end();
        });
        EXPECT_EQ(found_ids, expected);
        found += expected.size();
    }
    EXPECT_GT(found, 200u);
}

TEST(Queries, overlap_shape_finds_overlapping_shapes) {
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
            if (kind_of(s.geometry) > ShapeKind::hull) continue;  // not the oracle's
            const bool reported = std::find(touched.begin(), touched.end(), s.id) != touched.end();
            if (farther_apart_than(1e-4, probe, pose, s.geometry, s.pose)) {
                EXPECT_FALSE(reported) << "probe " << i << ", kind " << s.geometry.index();
                continue;
            }
            const double distance = separation(probe, pose, s.geometry, s.pose).distance;
            if (std::fabs(distance) < 1e-4) continue;  // too close to call for the oracle
            EXPECT_EQ(reported, distance < 0)
                << "probe " << i << " at distance " << distance << ", kind " << s.geometry.index();
            found += reported;
        }
    }
    EXPECT_GT(found, 20);
}

// All hits, each shape once, in order; any-hit agrees; batches are the single answers; a copy of
// the world answers the same, from several threads, while the world goes on.
TEST(Queries, all_any_batches_and_copies_agree) {
    RandomScene scene(7);
    Random random(8);
    std::vector<Ray> rays;
    for (int i = 0; i < 200; i++) rays.push_back({random.vector(9), random.vector(14)});
    const Queries live = scene.world.queries(), frame = scene.world.query_frame();
    const auto batch = must(live.cast_rays(rays));
    int with_many = 0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        const auto all = must(live.cast_ray_all(rays[i]));
        EXPECT_EQ(must(live.ray_hits_any(rays[i])), !all.empty());
        ASSERT_EQ(batch[i].has_value(), !all.empty());
        if (all.empty()) continue;
        EXPECT_EQ(batch[i]->shape, all[0].shape);
        with_many += all.size() > 2 ? 1 : 0;
        for (std::size_t k = 1; k < all.size(); k++) {
            EXPECT_LE(all[k - 1].fraction, all[k].fraction);
            EXPECT_NE(all[k - 1].shape, all[k].shape);
        }
        // Without the first body the next one is first.
        const auto without = must(live.cast_ray(rays[i], {.ignore = all[0].body}));
        EXPECT_TRUE(!without || without->body != all[0].body);
    }
    EXPECT_GT(with_many, 2);
    for (int i = 0; i < 30; i++) must(scene.world.step(1.0 / 60));
    std::vector<std::thread> askers;
    std::atomic<int> wrong = 0;
    for (int t = 0; t < 3; t++)
        askers.emplace_back([&] {
            const auto again = must(frame.cast_rays(rays));
            for (std::size_t i = 0; i < rays.size(); i++)
                wrong += again[i].has_value() != batch[i].has_value() ||
                                 (again[i] && again[i]->fraction != batch[i]->fraction)
                             ? 1
                             : 0;
        });
    for (int i = 0; i < 30; i++) must(scene.world.step(1.0 / 60));
    for (std::thread& asker : askers) asker.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(frame.step(), 0u);
    EXPECT_EQ(scene.world.queries().step(), 60u);
}

// A ball that moves: it touches when its centre's distance from the shape is its radius.
TEST(Queries, ball_casts_match_ray_marching) {
    const RandomScene scene(3);
    Random random(31);
    const double r = 0.25;
    int hits = 0;
    for (int i = 0; i < 200; i++) {
        const Vec3 start = random.vector(9), motion = random.vector(12);
        double t = 0;
        const double far = length(motion);
        const Placement* nearest_shape = nullptr;
        for (int step = 0; step < 5000 && t <= far; step++) {
            double nearest = 1e300;
            for (const Placement& s : scene.shapes) {
                const double d =
                    signed_distance(s.geometry, s.pose, start + motion * (t / far)) - r;
                if (d < nearest) nearest = d, nearest_shape = &s;
            }
            if (nearest < 1e-7) break;
            t += nearest;
        }
        const auto hit = must(scene.world.queries().cast_shape(
            {.geometry = Sphere{r}, .pose = {start, {}}, .motion = motion}));
        if (t > far) {
            EXPECT_TRUE(!hit || hit->fraction > 1 - 1e-4) << i;
            continue;
        }
        ASSERT_TRUE(hit.has_value()) << i;
        hits++;
        EXPECT_NEAR(hit->fraction * far, t, 2e-5)
            << i << " " << kind_name(kind_of(nearest_shape->geometry));
        if (t == 0) continue;
        const Vec3 center = start + motion * hit->fraction;
        EXPECT_TRUE(near(hit->point, center - hit->normal * r, 2e-3)) << i;
    }
    EXPECT_GT(hits, 60);
}

// Close to each other, they share a look into the broad phases; far apart they do not.
TEST(Queries, concurrent_casts_match_single_casts) {
    const RandomScene scene(21);
    Random random(22);
    const Queries queries = scene.world.queries();
    int hits = 0;
    for (int round = 0; round < 60; round++) {
        const Vec3 about = random.vector(6);
        std::vector<ShapeCast> casts;
        for (int k = 0; k < 1 + round % 20; k++)
            casts.push_back({RandomScene::random_convex(random),
                             {about + random.vector(round % 3 == 0 ? 9 : 1), random.rotation()},
                             random.vector(5)});
        const auto together = must(queries.cast_shapes(casts));
        ASSERT_EQ(together.size(), casts.size());
        for (std::size_t k = 0; k < casts.size(); k++) {
            const auto alone = must(queries.cast_shape(casts[k]));
            ASSERT_EQ(together[k].has_value(), alone.has_value());
            if (!alone) continue;
            hits++;
            EXPECT_EQ(together[k]->shape, alone->shape);
            EXPECT_EQ(together[k]->fraction, alone->fraction);
            EXPECT_EQ(together[k]->point, alone->point);
            EXPECT_EQ(together[k]->normal, alone->normal);
        }
    }
    EXPECT_GT(hits, 100);
}

// Any convex shape: before the hit it touches nothing, a little after it does.
TEST(Queries, cast_shapes_stop_at_the_first_touch) {
    const RandomScene scene(11);
    Random random(12);
    for (int i = 0; i < 150; i++) {
        const ShapeCast cast{RandomScene::random_convex(random),
                             {random.vector(9), random.rotation()},
                             random.vector(10)};
        const Queries queries = scene.world.queries();
        const auto hit = must(queries.cast_shape(cast));
        const auto touched_at = [&](double fraction) {
            return !must(queries.overlap_shape(
                             cast.geometry,
                             {cast.pose.position + cast.motion * fraction, cast.pose.rotation}))
                        .empty();
        };
        if (!hit) {
            for (const double f : {0.0, 0.3, 0.6, 1.0}) EXPECT_FALSE(touched_at(f)) << i;
            continue;
        }
        if (hit->fraction == 0) {
            EXPECT_TRUE(touched_at(0)) << i;
            continue;
        }
        for (const double f : {0.0, 0.5, 0.9, 1 - 1e-4})
            EXPECT_FALSE(touched_at(f * hit->fraction)) << i << " at " << f;
        // What only grazes may never overlap.
        const bool head_on = dot(hit->normal, normalized(cast.motion)) < -0.05;
        EXPECT_TRUE(touched_at(hit->fraction + 1e-3) || !head_on) << i;
    }
}

// A wheel with its axle level falls on a slope: it touches when its middle is a radius above it.
TEST(Queries, wheel_cast_touches_a_plane_one_radius_below_its_center) {
    World world = make_world({.gravity = {}});
    const Vec3 n = normalized(Vec3{0.3, 1, 0.1});
    const BodyId ground = must(world.create_body({.type = BodyType::static_body}));
    must(world.create_shape(ground, {.geometry = Plane{n}}));
    const Vec3 axle = normalized(cross(n, Vec3{0, 0, 1}));
    const Quat turn = normalized(Quat{axle.z, 0, -axle.x, 1 + axle.y});
    const Cylinder wheel{0.33, 0.11};
    ShapeCast cast{wheel, {{0, 2, 0}, turn}, {0, -4, 0}};
    const double leans = absolute(dot(rotate(turn, {0, 1, 0}), n));
    const double reach = 0.33 * square_root(1 - leans * leans) + 0.11 * leans;
    const auto hit = must(world.queries().cast_shape(cast));
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->fraction * 4, (2 * n.y - reach) / n.y, 1e-6);
    EXPECT_TRUE(near(hit->normal, n, 1e-12));
    EXPECT_NEAR(dot(hit->point, n), 0, 1e-12);
    cast.motion = {0, 1, 0};
    EXPECT_FALSE(must(world.queries().cast_shape(cast)).has_value());
    cast.pose.position = {0, 0, 0};
    EXPECT_EQ(must(world.queries().cast_shape(cast))->fraction, 0);
}

TEST(Queries, closest_point_is_the_nearest_surface) {
    const RandomScene scene(5);
    Random random(6);
    for (int i = 0; i < 300; i++) {
        const Vec3 p = random.vector(8);
        double nearest = 1e300;
        for (const Placement& s : scene.shapes)
            nearest = std::min(nearest, signed_distance(s.geometry, s.pose, p));
        const auto found = must(scene.world.queries().closest_point(p, 20));
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->distance, nearest, 1e-5) << i;
        EXPECT_NEAR(length(found->point - p), std::fabs(found->distance), 1e-5) << i;
        const auto none =
            must(scene.world.queries().closest_point(p, std::max(0.0, nearest - 0.01)));
        EXPECT_EQ(none.has_value(), nearest < 0) << i;
        const auto inside = must(scene.world.queries().shapes_at(p));
        EXPECT_EQ(!inside.empty(), nearest < 0) << i;
    }
}

TEST(Queries, filters_hide_categories_and_triggers) {
    World world = make_world({.gravity = {}});
    const BodyId wall =
        must(world.create_body({.type = BodyType::static_body, .pose = {{2, 0, 0}, {}}},
                               {.geometry = Box{{0.1, 1, 1}}, .filter = {.category = 4}}));
    must(world.create_body({.type = BodyType::static_body, .pose = {{1, 0, 0}, {}}},
                           {.geometry = Sphere{0.3}, .trigger = true}));
    const Ray ray{{0, 0, 0}, {5, 0, 0}};
    EXPECT_EQ(must(world.queries().cast_ray(ray))->body, wall);
    EXPECT_FALSE(must(world.queries().cast_ray(ray, {.categories = 3})));
    EXPECT_NEAR(must(world.queries().cast_ray(ray, {.triggers = true}))->fraction, 0.14, 1e-9);
}

}  // namespace
}  // namespace jostle::test
