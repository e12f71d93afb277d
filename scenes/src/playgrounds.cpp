// SPDX-License-Identifier: MIT
//
// Scenes in which a module has the leading part.
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

}  // namespace jostle::scenes
