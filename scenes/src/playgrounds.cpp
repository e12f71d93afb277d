// SPDX-License-Identifier: MIT
//
// Scenes in which a module has the leading part.
#include <string>

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

}  // namespace jostle::scenes
