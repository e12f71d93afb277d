// SPDX-License-Identifier: MIT
//
// A fall in still air: v = v_t tanh(g t / v_t), v_t = sqrt(2 m g / rho c A).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/world_builder.h"

namespace jostle::modules {

using namespace physics;

struct Fall {
    Geometry geometry;
    double density;  // kg/m^3
    double area;     // m^2
    double drag;     // coefficient
};

inline Fall ball_of_fall() {
    return {Sphere{0.1}, 120, pi * 0.01, 0.47};
}
inline Fall box_of_fall() {
    return {Box{{0.3, 0.1, 0.2}}, 60, 0.6 * 0.4, 1.05};
}

// The largest relative error of the speed over six seconds.
inline double worst_fall_error(const std::function<void(World& world, double drag)>& add_air,
                               const Fall& fall) {
    World world = test::make_world();
    const BodyId body = test::add(
        world, {.geometry = fall.geometry, .position = {0, 500, 0}, .density = fall.density});
    add_air(world, fall.drag);
    const double mass = test::state_of(world, body).mass;
    const double end = square_root(2 * mass * 9.81 / (1.2 * fall.drag * fall.area));
    double worst = 0;
    for (int step = 1; step <= 360; step++) {
        test::must(world.step(1.0 / 60));
        const double expected = end * std::tanh(9.81 * step / 60 / end);
        const double speed = -test::velocity_of(world, body).y;
        worst = maximum(worst, absolute(speed / expected - 1));
    }
    return worst;
}

}  // namespace jostle::modules
