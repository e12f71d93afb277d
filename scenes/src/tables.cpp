// SPDX-License-Identifier: MIT
//
// Small scenes about one law of physics: billiards (impacts), incline (friction), free space
// (momentum).
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription billiards() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{0, 5.2, 4.8}, {0, 0.7, 0.3}};
    const Material cloth{.friction = 0.2, .restitution = 0.5};
    const Material cushion{.friction = 0.14, .restitution = 0.85};
    const auto add_fixed = [&](const char* name, Vec3 center, Vec3 half, Material material,
                               std::uint32_t color) {
        SceneBody body = colored(fixed_box(name, center, half), color);
        body.shapes[0].material = material;
        scene.bodies.push_back(body);
    };
    // Twice the size of a real table (bed of 2.84 x 1.42 m, balls of 57 mm), which is easier to
    // watch.
    add_fixed("bed", {0, 0.7, 0}, {2.84, 0.1, 1.42}, cloth, 0x1b7a43);
    for (const double side : {-1.0, 1.0}) {
        add_fixed("cushion", {side * 2.94, 0.86, 0}, {0.1, 0.06, 1.62}, cushion, 0x5c3a21);
        add_fixed("cushion", {0, 0.86, side * 1.52}, {2.84, 0.06, 0.1}, cushion, 0x5c3a21);
    }
    constexpr double r = 0.057;
    constexpr std::uint32_t colors[] = {0xf4c20d, 0x1a56a8, 0xc0392b, 0x5b2c83,
                                        0xe67e22, 0x1e8449, 0x7b241c, 0x17202a};
    int number = 0;
    const auto add_ball = [&](const char* name, double x, double z, std::uint32_t color) {
        SceneBody ball = colored(dynamic_body(name, {x, 0.8 + r, z}, Sphere{r}), color);
        ball.shapes[0].material = {.friction = 0.1, .restitution = 0.95};
        ball.shapes[0].density = 1700;
        ball.body.linear_damping = 0.02;
        ball.body.angular_damping = 0.3;
        scene.bodies.push_back(ball);
    };
    for (int row = 0; row < 5; row++)
        for (int k = 0; k <= row; k++, number++)
            add_ball("ball", 1.2 + row * r * 1.735, (2 * k - row) * r * 1.002, colors[number % 8]);
    add_ball("cue ball", -1.6, 0.01, 0xf8f9f9);
    scene.bodies.back().body.linear_velocity = {7, 0, 0};
    return scene;
}

SceneDescription incline() {
    SceneDescription scene;
    scene.view = SceneView{{8, 9, 24}, {0, 0, 0}};
    const double tilt = 20 * pi / 180;
    const Quat slope = from_axis_angle({0, 0, 1}, -tilt);
    SceneBody ramp = fixed_box("ramp", {0, 0, 0}, {12, 0.5, 6}, slope);
    ramp.shapes[0].material.friction = 1;
    scene.bodies = {fixed_box("ground", {0, -11, 0}, {200, 1, 200}), ramp};
    for (int i = 0; i < 9; i++) {
        // The combined coefficient is sqrt(1 * f) = 0.1 i.
        const double mu = 0.1 * i;
        SceneBody box = colored(
            dynamic_body("mu 0." + std::to_string(i), rotate(slope, {-8, 0.75, (i - 4) * 1.2}),
                         Box{{0.4, 0.25, 0.4}}, slope),
            mu > 0.364 ? 0x81b29a : 0xe07a5f);
        box.shapes[0].material.friction = mu * mu;
        scene.bodies.push_back(box);
    }
    return scene;
}

SceneDescription free_space() {
    SceneDescription scene;
    scene.world.gravity = {};
    Random random(2026);
    for (int i = 0; i < 64; i++) {
        const Vec3 at{i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5};
        const double hx = random.in(0.1, 0.2), hy = random.in(0.1, 0.2), hz = random.in(0.1, 0.2);
        SceneBody box = dynamic_body("box", at, Box{{hx, hy, hz}});
        const double vx = random.in(-0.5, 0.5), vy = random.in(-0.5, 0.5),
                     vz = random.in(-0.5, 0.5);
        box.body.linear_velocity = at * -2 + Vec3{vx, vy, vz};
        const double wx = random.in(-3, 3), wy = random.in(-3, 3), wz = random.in(-3, 3);
        box.body.angular_velocity = {wx, wy, wz};
        box.shapes[0].material = {.friction = 0.5, .restitution = 0.5};
        scene.bodies.push_back(box);
    }
    return scene;
}

}  // namespace jostle::scenes
