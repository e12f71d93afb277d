// SPDX-License-Identifier: MIT
#include "scenes/src/bench_scene_parts.h"

#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription with_bench_defaults(SceneDescription scene) {
    scene.world.gravity = {0, -9.81, 0};
    for (SceneBody& body : scene.bodies) {
        body.body.linear_damping = body.body.angular_damping = 0.05;
        for (ShapeDef& shape : body.shapes) {
            shape.density = 1000;
            shape.material = {.friction = 0.5, .restitution = 0};
        }
    }
    return scene;
}

void add_bench_floor(SceneDescription& scene, double half_width) {
    scene.bodies.push_back(fixed_box("floor", {0, -1, 0}, {half_width, 1, half_width}));
}

void add_bench_walls(SceneDescription& scene, double half_width) {
    for (const double side : {1.0, -1.0})
        scene.bodies.push_back(
            fixed_box("wall", {side * (half_width + 0.5), 10, 0}, {0.5, 10, half_width + 1}));
    for (const double side : {1.0, -1.0})
        scene.bodies.push_back(
            fixed_box("wall", {0, 10, side * (half_width + 0.5)}, {half_width + 1, 10, 0.5}));
}

}  // namespace jostle::scenes
