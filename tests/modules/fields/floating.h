// SPDX-License-Identifier: MIT
//
// Buoyancy tests for the water of the solver and of the module. Each test takes a function that
// adds the water to a world.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::modules {

using namespace physics;

using AddWater = std::function<void(World& world, double drag, double damping)>;

inline double y_of(const World& world, BodyId body) {
    return test::position_of(world, body).y;
}

// Relative error of the draft, compared with h rho_b / rho_w.
inline double draft_error(const AddWater& add_water, double density) {
    World world = test::make_world();
    const BodyId box = test::add(world, {.geometry = Box{{1, 0.25, 1}},
                                         .position = {0, 0.25, 0},
                                         .density = density,
                                         .sleep_allowed = false});
    add_water(world, 20, 4);
    test::run(world, 30);
    const double draft = 0.25 - y_of(world, box), expected = 0.5 * density / 1000;
    return draft / expected - 1;
}

// Mean period, s, of the first oscillations of a box that is released slightly above its floating
// position.
inline double heave_period(const AddWater& add_water, double density, double lift) {
    World world = test::make_world();
    const double rest = 0.25 - 0.5 * density / 1000;
    const BodyId box = test::add(world, {.geometry = Box{{1, 0.25, 1}},
                                         .position = {0, rest + lift, 0},
                                         .density = density,
                                         .sleep_allowed = false});
    add_water(world, 0, 0);
    std::vector<double> crossings;  // downwards
    double previous = lift;
    for (int step = 1; crossings.size() < 6 && step < 6000; step++) {
        test::must(world.step(1.0 / 60));
        const double now = y_of(world, box) - rest;
        if (previous > 0 && now <= 0) crossings.push_back((step - now / (now - previous)) / 60);
        previous = now;
    }
    if (crossings.size() < 6) return 0;
    return (crossings.back() - crossings.front()) / 5;
}

// Final lean, degrees, of a box with an initial lean of 0.5: width x height, 4 widths long.
inline double lean_after(const AddWater& add_water, double width, double height, double density) {
    World world = test::make_world();
    const double rest = height * (0.5 - density / 1000);
    const BodyId box = test::add(world, {.geometry = Box{{width / 2, height / 2, 2 * width}},
                                         .position = {0, rest, 0},
                                         .rotation = from_axis_angle({0, 0, 1}, 0.5 * pi / 180),
                                         .density = density,
                                         .sleep_allowed = false});
    add_water(world, 1, 1);
    test::run(world, 60);
    const Vec3 up = rotate(test::state_of(world, box).pose.rotation, {0, 1, 0});
    return arc_tangent(length(cross(up, {0, 1, 0})), up.y) * 180 / pi;
}

// GM / height = s / 2 + (width / height)^2 / 12 s - 1 / 2 is zero for (width / height)^2 = 6 s (1 -
// s). Tests proportions 4 % above and below it, for several densities.
inline void expect_upright_exactly_when_gm_is_positive(const AddWater& add_water) {
    double most_stable = 0, least_unstable = 180;
    for (const double s : {0.15, 0.3, 0.5, 0.7, 0.85}) {
        const double neutral = square_root(6 * s * (1 - s));
        for (const double height : {0.5, 1.0}) {
            const double stable = lean_after(add_water, 1.04 * neutral * height, height, 1000 * s);
            const double unstable =
                lean_after(add_water, 0.96 * neutral * height, height, 1000 * s);
            EXPECT_LT(stable, 0.1) << "s " << s << ", height " << height;
            EXPECT_GT(unstable, 5) << "s " << s << ", height " << height;
            most_stable = maximum(most_stable, stable);
            least_unstable = minimum(least_unstable, unstable);
        }
    }
    testing::Test::RecordProperty("lean_of_stable_degrees", std::to_string(most_stable));
    testing::Test::RecordProperty("lean_of_unstable_degrees", std::to_string(least_unstable));
}

}  // namespace jostle::modules
