// SPDX-License-Identifier: MIT
//
// A world with the Destruction module, a wall to break, and measures of fractured shapes.
#pragma once

#include <memory>

#include "jostle/modules/destruction.h"

namespace jostle::modules {

// Registration allows worlds with the module to be loaded.
inline const bool registered =
    physics::register_module("destruction", [] { return std::make_unique<Destruction>(); }).ok();

inline double volume_of(const FracturedShape& shape) {
    double sum = 0;
    for (const FractureChunk& chunk : shape.chunks) sum += chunk.volume;
    return sum;
}

struct Stage {
    physics::World world;
    Destruction* destruction = nullptr;

    explicit Stage(const physics::WorldDef& def = {})
        : world(std::move(*physics::World::create(def))) {
        auto module = std::make_unique<Destruction>();
        destruction = module.get();
        world.add_module(std::move(module)).expect();
    }
    DestructibleId add(const FracturedShape& shape, const DestructibleDef& def = {}) {
        return destruction->add(world, shape, def).value();
    }
    void step(int count = 1, double dt = 1.0 / 60) {
        for (int k = 0; k < count; k++) world.step(dt).expect();
    }
    void floor() {
        world.create_body({.type = physics::BodyType::static_body}, {.geometry = physics::Plane{}})
            .value();
    }
    physics::BodyId ball(physics::Vec3 at, physics::Vec3 velocity, double radius = 0.3,
                         double density = 7800) {
        return world
            .create_body({.pose = {.position = at}, .linear_velocity = velocity},
                         {.geometry = physics::Sphere{radius}, .density = density})
            .value();
    }
};

// 4 m wide, 2 m high, 0.2 m thick; stands on the ground at x = 0 across z, anchored at its foot.
inline constexpr physics::Vec3 wall_half{0.1, 1, 2};
inline FracturedShape wall(int chunks = 60) {
    FracturedShape shape = fracture_box(wall_half, random_seeds(wall_half, chunks, 3)).value();
    anchor(shape, {0, -1, 0}, wall_half.y - 1e-6);
    return shape;
}
inline DestructibleDef standing() {
    return {.pose = {.position = {0, wall_half.y, 0}}};
}

}  // namespace jostle::modules
