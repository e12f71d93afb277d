// SPDX-License-Identifier: MIT
//
// Ray casts: finds the closest body along a ray, every body along a ray, and bodies of one
// category. A shape cast tests whether a ball fits through a gap.
//
// Shows: Queries, QueryFilter, cast_ray, cast_ray_all, cast_shape, closest_point.
// Run:   build/dev/bin/jostle-ray-cast
#include <cstdio>

#include "jostle/physics/physics.h"

using namespace jostle::physics;

namespace {

constexpr std::uint32_t scenery = 1, targets = 2;  // categories, one bit each

BodyId create_box(World& world, Vec3 position, std::uint32_t category) {
    return world
        .create_body({.type = BodyType::static_body, .pose = {.position = position}},
                     {.geometry = Box{{0.5, 0.5, 0.5}}, .filter = {.category = category}})
        .value();
}

}  // namespace

int main() {
    World world;
    // Three boxes in a row along x: a wall, a target and another wall.
    const BodyId wall = create_box(world, {3, 0, 0}, scenery);
    const BodyId target = create_box(world, {5, 0, 0}, targets);
    create_box(world, {7, 0, 0}, scenery);

    // Queries are valid until the world changes. A ray is an origin and a motion in metres.
    const Queries queries = world.queries();
    const Ray ray{.origin = {0, 0, 0}, .motion = {10, 0, 0}};

    const std::optional<RayHit> closest = queries.cast_ray(ray).value();
    std::printf("closest: %s at %.1f m, normal (%.0f, %.0f, %.0f)\n",
                closest->body == wall ? "wall" : "other", closest->fraction * 10, closest->normal.x,
                closest->normal.y, closest->normal.z);

    const std::optional<RayHit> aimed = queries.cast_ray(ray, {.categories = targets}).value();
    std::printf("closest target: %s at %.1f m\n", aimed->body == target ? "target" : "other",
                aimed->fraction * 10);

    std::printf("along the ray:");
    for (const RayHit& hit : queries.cast_ray_all(ray).value())
        std::printf(" %.1f m", hit.fraction * 10);
    std::printf("\n");

    // A ball of 0.4 m radius moves along x. At z = 0 it hits the wall, at z = 1 it passes.
    for (const double z : {0.0, 1.0}) {
        const auto hit = queries
                             .cast_shape({.geometry = Sphere{0.4},
                                          .pose = {.position = {0, 0, z}},
                                          .motion = {10, 0, 0}})
                             .value();
        if (hit)
            std::printf("ball at z = %.0f m: blocked after %.1f m\n", z, hit->fraction * 10);
        else
            std::printf("ball at z = %.0f m: passes\n", z);
    }

    const auto nearest = queries.closest_point({4, 2, 0}, 5).value();
    std::printf("nearest surface of (4, 2, 0): %.2f m away\n", nearest->distance);
    return closest->body == wall && aimed->body == target ? 0 : 1;
}
