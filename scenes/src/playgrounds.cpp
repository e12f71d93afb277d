// SPDX-License-Identifier: MIT
//
// Scenes in which a module has the leading part.
#include <string>

#include "jostle/physics/height_field.h"
#include "parts.h"

namespace jostle::scenes {

using namespace physics;

// Twelve figures at the head of a flight of stairs, on a ramp that tips them over.
SceneDescription ragdoll_stairs() {
    SceneDescription scene;
    scene.bodies.push_back(ground());
    constexpr int steps = 16;
    for (int k = 0; k < steps; k++) {
        const double top = 0.3 * (steps - k), z = 0.45 * k;
        scene.bodies.push_back(colored(fixed_box("step", {0, 0.5 * top, z}, {4, 0.5 * top, 0.225}),
                                       k % 2 ? 0xb8b8aa : 0x9a9a8c));
    }
    SceneBody ramp = fixed_box("ramp", {0, 0.3 * steps + 1.2, -2.6}, {4, 0.1, 2.6},
                               from_axis_angle({1, 0, 0}, 0.45));
    ramp.shapes[0].material.friction = 0.05;
    scene.bodies.push_back(colored(ramp, 0x6d6875));
    for (const double side : {-4.15, 4.15})
        scene.bodies.push_back(
            colored(fixed_box("wall", {side, 3.5, 2}, {0.15, 3.5, 8}), 0x3d405b));
    scene.modules.push_back(
        {.tag = "ragdoll",
         .settings =
             {{"count", 12}, {"spacing", 1.8}, {"x", -2.7}, {"y", 0.3 * steps + 2.6}, {"z", -4.6}},
         .bodies = {},
         .state = {}});
    return scene;
}

// Boats, crates and barrels on a swell, between a quay and a mole; a buoy on a chain.
SceneDescription harbour() {
    SceneDescription scene;
    scene.bodies.push_back(colored(fixed_box("sea bed", {0, -6, 0}, {60, 1, 60}), 0x264653));
    scene.bodies.push_back(colored(fixed_box("quay", {0, -2, -19}, {30, 3, 3}), 0x8d99ae));
    scene.bodies.push_back(colored(fixed_box("mole", {24, -2, 0}, {2, 3.3, 16}), 0x8d99ae));
    Random random(11);
    const auto floats = [&](const char* name, Vec3 at, Geometry geometry, double density,
                            std::uint32_t color) {
        SceneBody body = colored(loose(name, at, std::move(geometry)), color);
        body.shapes[0].density = density;
        scene.bodies.push_back(body);
    };
    for (int k = 0; k < 5; k++) {
        const double x = -18 + 8.5 * k;
        floats("boat", {x, 0.4, -8}, Box{{1.1, 0.45, 2.6}}, 180, 0xe76f51);
        scene.bodies.back().shapes.push_back(
            {.geometry = Box{{0.7, 0.5, 0.8}}, .pose = {{0, 0.9, 0.7}, {}}, .density = 40});
    }
    for (int k = 0; k < 24; k++) {
        const Vec3 at{random.in(-20, 18), random.in(1, 4), random.in(-3, 14)};
        if (k % 2 == 0)
            floats("crate", at, Box{{0.5, 0.4, 0.6}}, random.in(150, 700), 0xe9c46a);
        else
            floats("barrel", at, Cylinder{0.35, 0.5}, random.in(80, 500), 0x2a9d8f);
    }
    floats("buoy", {4, 0.3, 4}, Cone{0.6, 0.7}, 200, 0xd62828);
    const std::size_t buoy = scene.bodies.size() - 1;
    join(scene, "chain", 0, buoy, {{4, -5, 4}, {}},
         DistanceJoint{.min_length = 0, .max_length = 5.6});
    scene.joints.back().joint.frame_b = {{0, -0.7, 0}, {}};
    scene.modules.push_back({.tag = "fields",
                             .settings = {{"waves_level", 0},
                                          {"wave1_amplitude", 0.35},
                                          {"wave1_length", 16},
                                          {"wave1_heading", 0.4},
                                          {"wave2_amplitude", 0.12},
                                          {"wave2_length", 6},
                                          {"wave2_heading", -0.5},
                                          {"wave2_phase", 1},
                                          {"turbulence_wind_x", 2},
                                          {"turbulence_speed", 1.5},
                                          {"turbulence_scale", 8},
                                          {"turbulence_center_y", 20},
                                          {"turbulence_half_y", 19.9}},
                             .bodies = {},
                             .state = {}});
    return scene;
}

// Stairs, ramps up to the limit and past it, gaps, a roundabout, a swing bridge and crates to push;
// five characters stroll about until somebody drives them, one of them rigid.
SceneDescription parkour() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x588157));
    const auto block = [&](Vec3 center, Vec3 half, std::uint32_t color = 0xa3b18a, Quat turn = {}) {
        scene.bodies.push_back(colored(fixed_box("block", center, half, turn), color));
    };
    for (int k = 0; k < 8; k++)  // 30 cm each
        block({0, 0.15 * (k + 1), -6 - 0.5 * k}, {2, 0.15 * (k + 1), 0.25});
    block({0, 1.2, -12}, {2, 1.2, 2.25});
    for (int k = 0; k < 4; k++)
        block({4.0 + 3.2 * k, 2.2 - 0.1 * k, -12}, {1.1, 0.2, 1.1}, 0xdda15e);
    for (int k = 0; k < 3; k++) {  // 25, 40 and 55 degrees: the last is too steep
        const double angle = (25 + 15 * k) * pi / 180;
        block({-8.0 - 4 * k, 1, -6}, {1.6, 0.15, 3}, k < 2 ? 0xa3b18a : 0xbc4749,
              from_axis_angle({1, 0, 0}, angle));
    }
    for (int k = 0; k < 6; k++)  // higher and higher: 10 to 60 cm
        block({8, 0.05 * (k + 1), 2.0 + 2 * k}, {2, 0.05 * (k + 1), 0.5}, 0x6a994e);
    SceneBody roundabout = fixed_box("roundabout", {-8, 0.1, 6}, {3, 0.1, 3});
    roundabout.body.type = BodyType::kinematic;
    roundabout.body.angular_velocity = {0, 0.6, 0};
    roundabout.shapes[0].geometry = Cylinder{3, 0.1};
    scene.bodies.push_back(colored(roundabout, 0xf2cc8f));
    for (int k = 0; k < 10; k++)
        scene.bodies.push_back(colored(
            loose("crate", {-2 + 0.9 * (k % 5), 0.3 + 0.62 * (k / 5), 4}, Box{{0.3, 0.3, 0.3}}),
            0xbc6c25));
    for (std::size_t k = scene.bodies.size() - 10; k < scene.bodies.size(); k++)
        scene.bodies[k].shapes[0].density = 150;
    SceneModule walkers{.tag = "character",
                        .settings = {{"stroll", 1.5}, {"stroll_turn", 0.25}},
                        .bodies = {},
                        .state = {}};
    for (int k = 0; k < 5; k++) {
        SceneBody walker = loose("walker", {-4.0 + 2 * k, 0.91, 9}, Capsule{0.28, 0.6});
        walker.body.type = k == 4 ? BodyType::dynamic : BodyType::kinematic;
        if (k == 4) walker.shapes[0].mass = 80;
        walkers.bodies["walker" + std::to_string(k + 1)] = scene.bodies.size();
        scene.bodies.push_back(colored(walker, k == 4 ? 0xe63946 : 0x457b9d));
    }
    scene.modules.push_back(walkers);
    return scene;
}

// A ring of road between tyres, a hill on one side of it, and a ramp; pilots go round until
// somebody takes their wheel.
SceneDescription race_track() {
    SceneDescription scene;
    constexpr std::uint32_t samples = 121;
    HeightGrid grid{.columns = samples, .rows = samples, .spacing_x = 2, .spacing_z = 2};
    for (std::uint32_t r = 0; r < samples; r++)
        for (std::uint32_t c = 0; c < samples; c++) {
            const double x = 2.0 * (c - 60.0), z = 2.0 * (r - 60.0);
            const double hill = maximum(0, 1 - (x * x + (z - 45) * (z - 45)) / 900);
            grid.heights.push_back(2.5 * hill * hill);
        }
    SceneBody land{.name = "land", .body = {.type = BodyType::static_body}, .shapes = {}};
    land.shapes.push_back({.geometry = HeightField{*build_height_field(std::move(grid))},
                           .material = {.friction = 0.9}});
    scene.bodies.push_back(colored(land, 0x6b705c));
    for (int k = 0; k < 72; k++) {
        const SinCos at = sin_cos(2 * pi * k / 36 + (k < 36 ? 0 : 0.05));
        const double r = k < 36 ? 33 : 57;
        SceneBody tyre =
            loose("tyre", {r * at.cos, 0.16, r * at.sin - 0.001}, Cylinder{0.45, 0.15});
        tyre.body.pose.position.y += 3 * (at.sin > 0.3 ? 1 : 0);
        tyre.shapes[0].density = 90;
        scene.bodies.push_back(colored(tyre, k % 2 ? 0xf8f9fa : 0xd90429));
    }
    scene.bodies.push_back(
        colored(fixed_box("ramp", {45, 0.15, -14}, {3, 0.1, 4}, from_axis_angle({1, 0, 0}, 0.14)),
                0xffb703));
    SceneModule cars{.tag = "vehicle",
                     .settings = {{"pilot_radius", 45}, {"pilot_speed", 16}},
                     .bodies = {},
                     .state = {}};
    for (int k = 0; k < 6; k++) {
        // Side by side around the ring, each along its tangent: to the left, seen from above.
        const double turn = -0.25 * k;
        const SinCos at = sin_cos(turn);
        SceneBody car = loose("car", {45 * at.cos, 0.75, 45 * at.sin}, Box{{0.85, 0.25, 2}},
                              from_axis_angle({0, 1, 0}, -turn));
        car.shapes[0].mass = 1100;
        car.shapes.push_back(
            {.geometry = Box{{0.7, 0.25, 0.9}}, .pose = {{0, 0.48, 0.2}, {}}, .mass = 100});
        car.body.sleep_allowed = false;
        cars.bodies[k == 0 ? "car" : "car" + std::to_string(k + 1)] = scene.bodies.size();
        constexpr std::uint32_t colors[] = {0xe63946, 0x457b9d, 0xf4a261,
                                            0x2a9d8f, 0x8338ec, 0xffbe0b};
        scene.bodies.push_back(colored(car, colors[k]));
    }
    scene.modules.push_back(cars);
    return scene;
}

// Three walls of stones that hold together until a ball swings into them.
SceneDescription demolition() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x606c38));
    scene.modules.push_back({.tag = "destruction",
                             .settings = {{"count", 3},
                                          {"spacing", 7},
                                          {"width", 5},
                                          {"height", 4},
                                          {"thickness", 0.4},
                                          {"chunks", 120},
                                          {"x", -7},
                                          {"z", -6}},
                             .bodies = {},
                             .state = {}});
    for (int k = 0; k < 3; k++) {
        const double x = -7 + 7.0 * k;
        SceneBody ball = loose("ball", {x, 5.2, 3 + 2.0 * k}, Sphere{0.6});
        ball.shapes[0].density = 4000;
        scene.bodies.push_back(colored(ball, 0x283618));
        scene.bodies.push_back(
            colored(fixed_box("crane", {x, 11.2, -5}, {0.3, 0.3, 0.3}), 0xdda15e));
        const Vec3 from{x, 11.2, -5}, to = ball.body.pose.position;
        join(scene, "rope", scene.bodies.size() - 1, scene.bodies.size() - 2, {from, {}},
             DistanceJoint{.min_length = 0, .max_length = length(to - from)});
        scene.joints.back().joint.frame_b = {};
    }
    return scene;
}

}  // namespace jostle::scenes
