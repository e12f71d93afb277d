// SPDX-License-Identifier: MIT
//
// A world with the module Ropes, for its tests.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "jostle/modules/rope.h"

namespace jostle::modules {

inline constexpr double dt = 1.0 / 60, g = 9.81;

struct RopeWorld {
    physics::World world;
    Ropes* ropes;

    explicit RopeWorld(const physics::WorldDef& def = {}) : world(def) {
        auto module = std::make_unique<Ropes>();
        ropes = module.get();
        world.add_module(std::move(module)).expect();
    }
    physics::BodyId box(physics::Vec3 at, double mass, physics::Vec3 half = {0.2, 0.2, 0.2}) {
        const double volume = 8 * half.x * half.y * half.z;
        return world
            .create_body({.pose = {at, {}}},
                         {.geometry = physics::Box{half}, .density = mass / volume})
            .value();
    }
    void run(double seconds) {
        for (int n = 0; n < std::lround(seconds / dt); n++) world.step(dt).expect();
    }
    double length_of(RopeKey rope) const {
        double sum = 0;
        const auto x = ropes->positions(rope);
        for (std::size_t k = 1; k < x.size(); k++) sum += length(x[k] - x[k - 1]);
        return sum;
    }
};

}  // namespace jostle::modules
