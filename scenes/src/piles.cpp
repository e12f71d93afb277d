// SPDX-License-Identifier: MIT
//
// Piles of many mixed bodies.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

Geometry mixed(int i) {
    switch (i % 3) {
        case 0:
            return Sphere{0.3};
        case 1:
            return Box{{0.3, 0.25, 0.35}};
        default:
            return Capsule{0.2, 0.25};
    }
}

constexpr std::uint32_t palette[] = {0x4f86c6, 0xe07a5f, 0xf2cc8f, 0x81b29a, 0x9b5de5};

Quat any_rotation(Random& random) {
    const double x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
    return from_axis_angle({x, y, z}, random.in(0, 2 * pi));
}

void add_bin(SceneDescription& scene, double inner, double height) {
    const double h = height / 2, at = inner + 0.5;
    for (const double side : {-1.0, 1.0}) {
        scene.bodies.push_back(fixed_box("bin", {side * at, h, 0}, {0.5, h, inner + 1}));
        scene.bodies.push_back(fixed_box("bin", {0, h, side * at}, {inner + 1, h, 0.5}));
    }
}

}  // namespace

SceneDescription pile() {
    SceneDescription scene{.bodies = {ground()}};
    add_bin(scene, 5, 20);
    Random random;
    for (int i = 0; i < 1000; i++) {
        const int layer = i / 144, cell = i % 144;
        const double jx = random.in(-0.03, 0.03), jz = random.in(-0.03, 0.03);
        scene.bodies.push_back(colored(
            dynamic_body(
                "piece",
                {(cell % 12 - 5.5) * 0.75 + jx, 0.6 + 0.8 * layer, (cell / 12 - 5.5) * 0.75 + jz},
                mixed(i), any_rotation(random)),
            palette[i % 5]));
    }
    return scene;
}

SceneDescription rain() {
    SceneDescription scene{.bodies = {ground()}};
    for (int i = 0; i < 4; i++) {
        const double turn = i * pi / 2;
        const SinCos at = sin_cos(turn);
        scene.bodies.push_back(
            fixed_box("ramp", {4 * at.cos, 2, 4 * at.sin}, {3, 0.2, 3},
                      from_axis_angle({0, 1, 0}, -turn) * from_axis_angle({0, 0, 1}, 0.5)));
    }
    Random random(77);
    for (int i = 0; i < 300; i++) {
        const double x = random.in(-6, 6), y = random.in(6, 60), z = random.in(-6, 6);
        scene.bodies.push_back(colored(
            dynamic_body("drop", {x, y, z}, mixed(i), any_rotation(random)), palette[i % 5]));
    }
    return scene;
}

}  // namespace jostle::scenes
