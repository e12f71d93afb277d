// SPDX-License-Identifier: MIT
//
// A course for characters: up stairs, over widening gaps, along a beam, to a flag.
#include <string>

#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

void add_block(SceneDescription& scene, const char* name, Vec3 center, Vec3 half,
               std::uint32_t color, Quat turn = {}) {
    scene.bodies.push_back(colored(fixed_box(name, center, half, turn), color));
}

// The course from the start to the flag.
void add_course(SceneDescription& scene) {
    for (int k = 0; k < 8; k++)  // 30 cm each
        add_block(scene, "stair", {0, 0.15 * (k + 1), -6 - 0.5 * k}, {2, 0.15 * (k + 1), 0.25},
                  k % 2 ? 0xcfc6a8 : 0xb3a988);
    add_block(scene, "platform", {0, 1.2, -12}, {2, 1.2, 2.25}, 0xcfc6a8);
    double x = 2;
    for (int k = 0; k < 4; k++) {  // gaps of 1, 1.5, 2 and 2.5 m
        x += 1 + 0.5 * k;
        add_block(scene, "stone", {x + 1, 1.1, -12}, {1, 1.1, 1}, 0xdda15e);
        x += 2;
    }
    add_block(scene, "beam", {17, 2.1, -6.5}, {0.3, 0.1, 4.5}, 0xf4a261);
    add_block(scene, "goal", {17, 1.1, 0}, {2, 1.1, 2}, 0x2a9d8f);
    SceneBody pole = fixed_box("pole", {18.3, 3.7, 1.3}, {0.06, 1.5, 0.06});
    pole.shapes[0].geometry = Cylinder{0.06, 1.5};
    scene.bodies.push_back(colored(pole, 0xf1faee));
    add_block(scene, "flag", {17.75, 4.8, 1.3}, {0.5, 0.3, 0.03}, 0xe63946);
}

// Obstacles next to the course.
void add_gym(SceneDescription& scene) {
    for (int k = 0; k < 3; k++) {  // 25, 40 and 55 degrees: the last is too steep
        const double angle = (25 + 15 * k) * pi / 180;
        add_block(scene, "ramp", {-8.0 - 4 * k, 1, -6}, {1.6, 0.15, 3}, k < 2 ? 0xa3b18a : 0xbc4749,
                  from_axis_angle({1, 0, 0}, angle));
    }
    for (int k = 0; k < 6; k++)  // higher and higher: 10 to 60 cm
        add_block(scene, "hurdle", {8, 0.05 * (k + 1), 2.0 + 2 * k}, {2, 0.05 * (k + 1), 0.5},
                  k < 4 ? 0x6a994e : 0xbc4749);
    SceneBody roundabout = fixed_box("roundabout", {-8, 0.1, 6}, {3, 0.1, 3});
    roundabout.body.type = BodyType::kinematic;
    roundabout.body.angular_velocity = {0, 0.6, 0};
    roundabout.shapes[0].geometry = Cylinder{3, 0.1};
    scene.bodies.push_back(colored(roundabout, 0xf2cc8f));
    SceneBody seesaw = dynamic_body("seesaw", {-16, 0.6, 5}, Box{{2.4, 0.06, 0.7}});
    seesaw.shapes[0].density = 250;
    add_block(scene, "trestle", {-16, 0.25, 5}, {0.12, 0.25, 0.7}, 0x8d99ae);
    scene.bodies.push_back(colored(seesaw, 0xe9c46a));
    join(scene, "axle", scene.bodies.size() - 2, scene.bodies.size() - 1, {{-16, 0.6, 5}, {}},
         HingeJoint{});
    for (int k = 0; k < 10; k++) {
        SceneBody crate = dynamic_body("crate", {-2 + 0.9 * (k % 5), 0.3 + 0.62 * (k / 5), 4},
                                       Box{{0.3, 0.3, 0.3}});
        crate.shapes[0].density = 150;
        scene.bodies.push_back(colored(crate, 0xbc6c25));
    }
}

}  // namespace

// Five characters, one of them rigid, that stroll until a client controls them.
SceneDescription parkour() {
    SceneDescription scene;
    scene.bodies.push_back(colored(ground(), 0x588157));
    add_course(scene);
    add_gym(scene);
    SceneModule walkers{.tag = "character",
                        .settings = {{"stroll", 1.5}, {"stroll_turn", 0.25}},
                        .bodies = {},
                        .state = {}};
    constexpr std::uint32_t colors[] = {0x457b9d, 0xffb703, 0x8338ec, 0xf28482, 0xe63946};
    for (int k = 0; k < 5; k++) {
        const std::string name = "walker" + std::to_string(k + 1);
        SceneBody walker = dynamic_body(name, {-4.0 + 2 * k, 0.91, 9}, Capsule{0.28, 0.6});
        walker.body.type = k == 4 ? BodyType::dynamic : BodyType::kinematic;
        if (k == 4) walker.shapes[0].mass = 80;
        walkers.bodies[name] = scene.bodies.size();
        scene.bodies.push_back(colored(walker, colors[k]));
    }
    scene.modules.push_back(walkers);
    return scene;
}

}  // namespace jostle::scenes
