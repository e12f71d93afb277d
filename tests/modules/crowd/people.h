// SPDX-License-Identifier: MIT
//
// Worlds with a crowd, for tests.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "jostle/modules/crowd.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {

inline Crowd& crowd_of(physics::World& world) {
    return dynamic_cast<Crowd&>(*world.module("crowd"));
}

// Adds a crowd with these settings.
inline Crowd& add_crowd(physics::World& world, const CrowdSettings& settings = {}) {
    test::must(world.add_module(std::make_unique<Crowd>()));
    test::must(crowd_of(world).set_settings(settings));
    return crowd_of(world);
}

// An upright capsule of 1.8 m on the plane y = 0.
inline physics::BodyId add_person(physics::World& world, physics::Vec3 feet,
                                  physics::BodyType type = physics::BodyType::kinematic,
                                  double radius = 0.2) {
    return test::must(
        world.create_body({.type = type, .pose = {feet + physics::Vec3{0, 0.9, 0}, {}}},
                          {.geometry = physics::Capsule{radius, 0.9 - radius},
                           .material = {.friction = 0, .friction_rule = physics::Combine::multiply},
                           .mass = 75}));
}

inline Destination to_point(physics::Vec3 point) {
    return {.aim = Aim::point, .point = point};
}
inline Destination to_goal(std::uint32_t goal) {
    return {.aim = Aim::goal, .goal = goal};
}
inline Destination moving(physics::Vec3 velocity) {
    return {.aim = Aim::move, .velocity = velocity};
}

// n agents without bodies on a circle, each of which walks to the opposite point.
inline std::vector<AgentId> add_circle(physics::World& world, int n, double circle, double radius) {
    std::vector<AgentId> ids;
    for (int k = 0; k < n; k++) {
        const physics::SinCos turn = physics::sin_cos(2 * physics::pi * k / n);
        const physics::Vec3 p{circle * turn.cos, 0, circle * turn.sin};
        ids.push_back(test::must(crowd_of(world).add(
            world, {.position = p, .radius = radius, .speed = 1.3, .destination = to_point(-p)})));
    }
    return ids;
}

inline std::vector<physics::Vec3> positions_of(physics::World& world) {
    std::vector<physics::Vec3> points;
    for (const AgentId id : crowd_of(world).ids())
        points.push_back(test::must(crowd_of(world).state(world, id)).position);
    return points;
}

// Largest overlap of discs of one radius, m. `up`: component that does not count: 1 for y, 2 for z.
inline double largest_overlap(std::vector<physics::Vec3> points, double radius, int up = 1) {
    const auto second = [up](physics::Vec3 p) { return up == 1 ? p.z : p.y; };
    std::ranges::sort(points, {}, &physics::Vec3::x);
    double worst = 0;
    for (std::size_t a = 0; a < points.size(); a++)
        for (std::size_t b = a + 1; b < points.size() && points[b].x - points[a].x < 2 * radius;
             b++) {
            const double x = points[b].x - points[a].x, y = second(points[b]) - second(points[a]);
            worst = std::max(worst, 2 * radius - physics::square_root(x * x + y * y));
        }
    return worst;
}

}  // namespace jostle::modules
