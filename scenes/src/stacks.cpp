// SPDX-License-Identifier: MIT
//
// Stacks and walls, which must remain standing.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription stack() {
    SceneDescription scene{.bodies = {ground()}};
    for (int i = 0; i < 10; i++)
        scene.bodies.push_back(dynamic_body("box " + std::to_string(i), {0, 0.5 + i, 0}, Box{}));
    return scene;
}

SceneDescription pyramid() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{14, 17, 50}, {0, 13.5, 0}};
    constexpr int rows = 30;
    for (int row = 0; row < rows; row++)
        for (int k = 0; k < rows - row; k++)
            scene.bodies.push_back(
                dynamic_body("box " + std::to_string(row) + "." + std::to_string(k),
                             {(k - (rows - row - 1) / 2.0) * 1.05, 0.5 + row, 0}, Box{}));
    return scene;
}

SceneDescription wall() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{12, 6, 16}, {0, 2.5, 1}};
    constexpr int rows = 12, bricks = 12;
    for (int row = 0; row < rows; row++)
        for (int k = 0; k < bricks; k++)
            scene.bodies.push_back(colored(
                dynamic_body("brick",
                             {(k - bricks / 2.0 + (row % 2) * 0.5) * 1.01, 0.25 + 0.5 * row, 0},
                             Box{{0.5, 0.25, 0.25}}),
                row % 2 == 0 ? 0xb5533c : 0xc4694f));
    SceneBody ball = colored(dynamic_body("ball", {0, 2.5, 14}, Sphere{0.8}), 0x30343f);
    ball.body.linear_velocity = {0, 3, -14};
    ball.shapes[0].density = 4000;
    scene.bodies.push_back(ball);
    return scene;
}

SceneDescription dominoes() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{2, 13, 13}, {0, 0, 0.5}};
    // Along the spiral r = 2 + 0.35 angle, one domino every 0.42 m of arc.
    double angle = 0;
    for (int i = 0; i < 120; i++) {
        const double r = 2 + 0.35 * angle;
        const SinCos at = sin_cos(angle);
        SceneBody domino =
            colored(dynamic_body("domino", {r * at.cos, 0.5, r * at.sin}, Box{{0.25, 0.5, 0.06}},
                                 from_axis_angle({0, 1, 0}, -angle)),
                    i % 2 == 0 ? 0xf2e8cf : 0x386641);
        if (i == 0) {
            // Its face points along the spiral, and it starts falling over.
            domino.body.angular_velocity = {1.8 * at.cos, 0, 1.8 * at.sin};
            domino.body.linear_velocity = {-0.9 * at.sin, 0, 0.9 * at.cos};
        }
        scene.bodies.push_back(domino);
        angle += 0.42 / r;
    }
    return scene;
}

}  // namespace jostle::scenes
