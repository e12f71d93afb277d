// SPDX-License-Identifier: MIT
//
// Scenes that demonstrate one module: falling figures, breaking walls.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

// Twelve figures on a ramp at the top of a flight of stairs, which tips them over, and a character
// to walk up to them.
SceneDescription ragdoll_stairs() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x7f8c7d));
    constexpr int steps = 16;
    constexpr double rise = 0.3, tread = 0.45, slope = 0.588;  // rad: atan(rise / tread)
    for (int k = 0; k < steps; k++) {
        const double top = rise * (steps - k), z = tread * k;
        scene.bodies.push_back(colored(fixed_box("step", {0, 0.5 * top, z}, {4, 0.5 * top, 0.225}),
                                       k % 2 ? 0xd8cfb8 : 0xb9ad92));
    }
    SceneBody ramp = fixed_box("ramp", {0, rise * steps + 1.2, -2.6}, {4, 0.1, 2.6},
                               from_axis_angle({1, 0, 0}, 0.45));
    ramp.shapes[0].material.friction = 0.05;
    scene.bodies.push_back(colored(ramp, 0x6d6875));
    for (const double side : {-4.1, 4.1}) {
        scene.bodies.push_back(colored(fixed_box("rail", {side, rise * steps + 1.5, -2.6},
                                                 {0.1, 0.5, 2.7}, from_axis_angle({1, 0, 0}, 0.45)),
                                       0x8c4a3c));
        scene.bodies.push_back(colored(fixed_box("rail", {side, 2.75, 3.4}, {0.1, 0.6, 4.4},
                                                 from_axis_angle({1, 0, 0}, slope)),
                                       0x8c4a3c));
        scene.bodies.push_back(
            colored(fixed_box("rail", {side, 0.3, 9.3}, {0.1, 0.3, 2.4}), 0x8c4a3c));
    }
    scene.modules.push_back(
        {.tag = "ragdoll",
         .settings =
             {{"count", 12}, {"spacing", 1.8}, {"x", -2.7}, {"y", rise * steps + 2.6}, {"z", -4.6}},
         .bodies = {},
         .state = {}});
    SceneModule walkers{.tag = "character", .settings = {}, .bodies = {}, .state = {}};
    walkers.bodies["walker"] = scene.bodies.size();
    SceneBody walker = dynamic_body("walker", {2.5, 0.91, 11}, Capsule{0.28, 0.6});
    walker.body.type = BodyType::kinematic;
    scene.bodies.push_back(colored(walker, 0xffb703));
    scene.modules.push_back(walkers);
    return scene;
}

// Walls of bonded stones, hit by a ball on a rope, and a digger that a client can drive.
SceneDescription demolition() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x8a8465));
    scene.modules.push_back({.tag = "destruction",
                             .settings = {{"count", 3},
                                          {"spacing", 7},
                                          {"width", 5},
                                          {"height", 4},
                                          {"thickness", 0.4},
                                          {"chunks", 120},
                                          {"tensile", 2e5},  // Pa: bricks in weak mortar
                                          {"shear", 4e5},
                                          {"fracture_energy", 5},
                                          {"x", -7},
                                          {"z", -6}},
                             .bodies = {},
                             .state = {}});
    // At the lowest point of its swing, a ball touches its wall. The first ball starts raised; the
    // second hangs at rest until a client pulls it back.
    constexpr double crane_top = 11.2, wall_front = -5.8, radius = 0.6, rope = 10;
    constexpr std::uint32_t steel = 0xe9a23b;
    for (int k = 0; k < 2; k++) {
        const double x = -7 + 7.0 * k, z = wall_front + radius + 0.05;
        const Vec3 from{x, crane_top, z}, direction = k == 0 ? Vec3{0, -0.8, 0.6} : Vec3{0, -1, 0};
        SceneBody ball = dynamic_body("ball", from + direction * rope, Sphere{radius});
        ball.shapes[0].density = 4000;
        scene.bodies.push_back(colored(ball, 0x2f3437));
        scene.bodies.push_back(
            colored(fixed_box("crane", {x, crane_top + 0.2, z - 2}, {0.2, 0.2, 2.4}), steel));
        scene.bodies.push_back(colored(
            fixed_box("crane", {x, 0.5 * crane_top, z - 4.2}, {0.25, 0.5 * crane_top, 0.25}),
            steel));
        join(scene, "rope", scene.bodies.size() - 2, scene.bodies.size() - 3, {from, {}},
             DistanceJoint{.min_length = 0, .max_length = rope});
        scene.joints.back().joint.frame_b = {};
    }
    SceneBody digger = dynamic_body("digger", {7, 1.2, 10}, Box{{1.1, 0.35, 2.2}});
    digger.shapes[0].mass = 4000;
    digger.shapes.push_back(
        {.geometry = Box{{0.8, 0.55, 0.8}}, .pose = {{0, 0.9, 0.7}, {}}, .mass = 300});
    digger.shapes.push_back(
        {.geometry = Box{{0.2, 0.2, 0.9}}, .pose = {{0, 0.55, -2.9}, {}}, .mass = 400});
    digger.body.sleep_allowed = false;
    scene.modules.push_back({.tag = "vehicle",
                             .settings = {{"track", 2.3},
                                          {"wheel_base", 2.8},
                                          {"radius", 0.5},
                                          {"width", 0.5},
                                          {"front_drive", 0.5},
                                          {"friction", 1.6},
                                          {"power_scale", 2}},
                             .bodies = {{"car", scene.bodies.size()}},
                             .state = {}});
    scene.bodies.push_back(colored(digger, 0xf2b705));
    return scene;
}

}  // namespace jostle::scenes
