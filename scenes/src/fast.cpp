// SPDX-License-Identifier: MIT
//
// Fast bodies that test continuous collision detection: bullets at thin walls, spinning rods at
// posts.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription bullets() {
    SceneDescription scene{.bodies = {ground()}};
    scene.bodies.push_back(colored(fixed_box("wall", {6, 2.5, 0}, {0.025, 2.5, 6}), 0x6c757d));
    Random random(19);
    for (int i = 0; i < 120; i++) {
        const double x = random.in(-60, -8);
        SceneBody bullet = colored(
            dynamic_body("bullet", {x, 0.4 + (i / 12) * 0.4, (i % 12 - 5.5) * 0.7}, Sphere{0.06}),
            0xffb703);
        bullet.body.linear_velocity = {200, 0, 0};
        bullet.body.gravity_scale = 0.2;
        bullet.shapes[0].material.restitution = 0.4;
        bullet.shapes[0].density = 7800;
        scene.bodies.push_back(bullet);
    }
    // Crates in the path of some bullets.
    for (int k = 0; k < 6; k++)
        scene.bodies.push_back(colored(
            dynamic_body("crate", {2, 0.5 + (k % 2), (k / 2 - 1) * 2.4}, Box{{0.5, 0.5, 0.5}}),
            0xa47148));
    for (int k = 0; k < 4; k++) {
        const Vec3 at{-3.0 - 3 * k, 1.2, 9};
        scene.bodies.push_back(fixed_box("post", at + Vec3{0, 0, 0.8}, {0.02, 1.2, 0.02}));
        SceneBody rod = colored(dynamic_body("rod", at, Box{{1, 0.03, 0.03}}), 0xe63946);
        rod.body.angular_velocity = {0, -40.0 * (k + 1), 0};
        rod.body.gravity_scale = 0;
        scene.bodies.push_back(rod);
    }
    return scene;
}

}  // namespace jostle::scenes
