// SPDX-License-Identifier: MIT
//
// A world with the module Cloths, for its tests.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "jostle/modules/cloth.h"

namespace jostle::modules {

inline constexpr double dt = 1.0 / 60, g = 9.81;

struct ClothWorld {
    physics::World world;
    Cloths* cloths;

    explicit ClothWorld(const physics::WorldDef& def = {}) : world(def) {
        auto module = std::make_unique<Cloths>();
        cloths = module.get();
        world.add_module(std::move(module)).expect();
    }
    physics::BodyId box(physics::Vec3 at, double mass, physics::Vec3 half = {0.2, 0.2, 0.2},
                        physics::Vec3 velocity = {}) {
        const double volume = 8 * half.x * half.y * half.z;
        return world
            .create_body({.pose = {at, {}}, .linear_velocity = velocity},
                         {.geometry = physics::Box{half}, .density = mass / volume})
            .value();
    }
    physics::BodyId ball(physics::Vec3 at, double mass, double radius,
                         physics::Vec3 velocity = {}) {
        const double volume = 4.0 / 3 * physics::pi * radius * radius * radius;
        return world
            .create_body({.pose = {at, {}}, .linear_velocity = velocity},
                         {.geometry = physics::Sphere{radius}, .density = mass / volume})
            .value();
    }
    void pin(ClothKey cloth, std::uint32_t vertex) {
        cloths->attach(world, cloth, {.vertex = vertex, .point = cloths->positions(cloth)[vertex]})
            .expect();
    }
    // The border of a grid.
    void pin_border(ClothKey cloth) {
        const ClothGrid& grid = cloths->def(cloth).grid;
        for (std::uint32_t r = 0; r < grid.rows; r++)
            for (std::uint32_t c = 0; c < grid.columns; c++)
                if (r == 0 || c == 0 || r + 1 == grid.rows || c + 1 == grid.columns)
                    pin(cloth, r * grid.columns + c);
    }
    void run(double seconds) {
        for (int n = 0; n < std::lround(seconds / dt); n++) world.step(dt).expect();
    }
    physics::Vec3 momentum(ClothKey cloth) const {
        physics::Vec3 sum;
        const auto v = cloths->velocities(cloth);
        const auto m = cloths->masses(cloth);
        for (std::size_t k = 0; k < v.size(); k++) sum += v[k] * m[k];
        return sum;
    }
    physics::Vec3 momentum(physics::BodyId id) const {
        const physics::BodyState body = world.body(id).value();
        return body.linear_velocity * body.mass;
    }
};

}  // namespace jostle::modules
