// SPDX-License-Identifier: MIT
//
// The default yard of jostle-server: walls that contain bodies, and bodies to throw.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double yard = 11;  // m from the middle to a wall

void add_walls(SceneDescription& scene) {
    for (const double side : {-1.0, 1.0}) {
        scene.bodies.push_back(colored(
            fixed_box("wall", {side * (yard + 0.5), 0.75, 0}, {0.5, 0.75, yard + 1}), 0x6c757d));
        scene.bodies.push_back(colored(
            fixed_box("wall", {0, 0.75, side * (yard + 0.5)}, {yard, 0.75, 0.5}), 0x6c757d));
    }
}

void add_stacks(SceneDescription& scene) {
    // A pyramid of boxes, a tower and a low wall.
    for (int row = 0; row < 8; row++)
        for (int k = 0; k < 8 - row; k++)
            scene.bodies.push_back(colored(
                dynamic_body("box", {-5 + (k - (7 - row) / 2.0) * 0.63, 0.3 + 0.6 * row, -6},
                             Box{{0.3, 0.3, 0.3}}),
                row % 2 == 0 ? 0xe9c46a : 0xf4a261));
    for (int i = 0; i < 10; i++)
        scene.bodies.push_back(
            colored(dynamic_body("tower", {6, 0.35 + 0.7 * i, -6}, Box{{0.35, 0.35, 0.35}},
                                 from_axis_angle({0, 1, 0}, 0.1 * i)),
                    i % 2 == 0 ? 0x2a9d8f : 0x8ab17d));
    for (int row = 0; row < 5; row++)
        for (int k = 0; k < 8; k++)
            scene.bodies.push_back(colored(
                dynamic_body("brick", {2 + (k - 3.5 + (row % 2) * 0.5) * 0.61, 0.15 + 0.3 * row, 5},
                             Box{{0.3, 0.15, 0.2}}),
                row % 2 == 0 ? 0xb5533c : 0xc4694f));
}

void add_loose_objects(SceneDescription& scene) {
    Random random(7);
    for (int i = 0; i < 60; i++) {
        const double x = random.in(-9, 9), z = random.in(-2.5, 2.5), r = random.in(0.18, 0.4);
        scene.bodies.push_back(colored(dynamic_body("ball", {x, 0.5 + 0.05 * i, z}, Sphere{r}),
                                       i % 3 == 0 ? 0x457b9d : (i % 3 == 1 ? 0xe63946 : 0xf1faee)));
    }
    for (int i = 0; i < 36; i++) {
        const double x = random.in(-9, -3), z = random.in(4, 9), turn = random.in(0, pi);
        scene.bodies.push_back(
            colored(dynamic_body("capsule", {x, 0.6 + 0.1 * i, z}, Capsule{0.18, 0.3},
                                 from_axis_angle({1, 0, 0.3}, turn)),
                    0x9b5de5));
    }
}

void add_ramps(SceneDescription& scene) {
    scene.bodies.push_back(
        colored(fixed_box("ramp", {8, 0.6, 1}, {2, 0.15, 1.5}, from_axis_angle({0, 0, 1}, 0.35)),
                0x495057));
    scene.bodies.push_back(colored(
        fixed_box("ramp", {-8.5, 0.5, -1}, {1.5, 0.15, 1.5}, from_axis_angle({0, 0, 1}, -0.35)),
        0x495057));
}

void add_dominoes(SceneDescription& scene) {
    for (int i = 0; i < 24; i++)
        scene.bodies.push_back(
            colored(dynamic_body("domino", {-4 + 0.35 * i, 0.4, 8.5}, Box{{0.05, 0.4, 0.2}}),
                    i % 2 == 0 ? 0xf2e8cf : 0x386641));
}

}  // namespace

SceneDescription sandbox() {
    SceneDescription scene{.bodies = {colored(ground(), 0x7f8f6a)}};
    add_walls(scene);
    add_stacks(scene);
    add_loose_objects(scene);
    add_ramps(scene);
    add_dominoes(scene);
    // A little air drag brings rolling bodies to rest.
    for (SceneBody& body : scene.bodies) {
        body.body.linear_damping = 0.05;
        body.body.angular_damping = 0.2;
    }
    return scene;
}

}  // namespace jostle::scenes
