// SPDX-License-Identifier: MIT
//
// Scenes about one feature each: shapes, belts, gates, locks.
#include "jostle/physics/compound.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription shapes() {
    SceneDescription scene{.bodies = {ground()}};
    for (const double side : {-1.0, 1.0}) {
        scene.bodies.push_back(fixed_box("wall", {side * 4.5, 1, 0}, {0.3, 1, 4.8}));
        scene.bodies.push_back(fixed_box("wall", {0, 1, side * 4.5}, {4.2, 1, 0.3}));
    }
    Random random(3);
    const Geometry jack = Compound{*build_compound({{Box{{0.4, 0.07, 0.07}}, {}},
                                                    {Box{{0.07, 0.4, 0.07}}, {}},
                                                    {Box{{0.07, 0.07, 0.4}}, {}}})};
    const Geometry kinds[] = {
        stone(random, 0.35), Cylinder{0.28, 0.22}, Cone{0.3, 0.35},       jack,
        Sphere{0.28},        Capsule{0.18, 0.25},  Box{{0.3, 0.2, 0.25}}, stone(random, 0.45)};
    const std::uint32_t colors[] = {0x8ecae6, 0x219ebc, 0xffb703, 0xfb8500,
                                    0xe63946, 0x9b5de5, 0x2a9d8f, 0xadb5bd};
    for (int i = 0; i < 160; i++) {
        const double x = random.in(-3.2, 3.2), z = random.in(-3.2, 3.2), turn = random.in(0, 3);
        scene.bodies.push_back(colored(dynamic_body("thing", {x, 1 + 0.16 * i, z}, kinds[i % 8],
                                                    from_axis_angle({x, 1, z}, turn)),
                                       colors[i % 8]));
        scene.bodies.back().shapes[0].material.rolling_friction = 0.003;
    }
    return scene;
}

SceneDescription conveyor() {
    SceneDescription scene{.bodies = {ground()}};
    // A ring of conveyor belts that feed each other, with a rail on either side.
    const Vec3 centers[] = {{-0.7, 0.4, -3}, {3, 0.4, -0.7}, {0.7, 0.4, 3}, {-3, 0.4, 0.7}};
    const Vec3 along[] = {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
    for (int k = 0; k < 4; k++) {
        const bool x = along[k].x != 0;
        SceneBody belt = colored(
            fixed_box("belt", centers[k], x ? Vec3{3, 0.1, 0.7} : Vec3{0.7, 0.1, 3}), 0x495057);
        belt.shapes[0].material = {.friction = 0.9, .surface_velocity = along[k] * 1.5};
        scene.bodies.push_back(belt);
        const Vec3 out = cross(along[k], Vec3{0, 1, 0}) * -1;
        for (const double from_middle : {3.8, 2.2}) {
            const double half = from_middle > 3 ? 3.9 : 2.1;
            SceneBody rail = fixed_box("rail", out * -from_middle + Vec3{0, 0.65, 0},
                                       x ? Vec3{half, 0.35, 0.1} : Vec3{0.1, 0.35, half});
            rail.shapes[0].material = {.friction = 0.05, .friction_rule = Combine::minimum};
            scene.bodies.push_back(colored(rail, 0x6c757d));
        }
    }
    for (int i = 0; i < 24; i++) {
        const Geometry kinds[] = {Box{{0.22, 0.18, 0.25}}, Cylinder{0.2, 0.2},
                                  Box{{0.3, 0.12, 0.2}}, Sphere{0.2}};
        scene.bodies.push_back(colored(
            dynamic_body("parcel", {(i % 8 - 3.5) * 0.75, 1.4 + 0.6 * (i / 8), -3}, kinds[i % 4]),
            i % 4 == 3 ? 0xe63946 : (i % 2 == 0 ? 0xe9c46a : 0x457b9d)));
        scene.bodies.back().shapes[0].material = {.friction = 0.8, .rolling_friction = 0.05};
    }
    return scene;
}

SceneDescription gates() {
    SceneDescription scene{.bodies = {ground()}};
    constexpr std::uint32_t red = 2, blue = 4;
    for (int k = 0; k < 3; k++) {
        SceneBody gate = fixed_box("gate", {0, 5.0 - 1.4 * k, 0}, {3, 0.15, 3});
        gate.shapes[0].trigger = true;
        gate.color = 0x80ed99;
        scene.bodies.push_back(gate);
    }
    for (const auto& [name, x, sees, color] : {std::tuple("red sieve", -1.6, red, 0xd62828u),
                                               std::tuple("blue sieve", 1.6, blue, 0x1d4ed8u)}) {
        SceneBody sieve = colored(fixed_box(name, {x, 1.6, 0}, {1.5, 0.08, 3},
                                            from_axis_angle({0, 0, 1}, x < 0 ? 0.12 : -0.12)),
                                  color);
        sieve.shapes[0].filter.mask = sees;
        scene.bodies.push_back(sieve);
    }
    SceneBody cross{.name = "cross",
                    .body = {.type = BodyType::kinematic,
                             .pose = {{0, 0.3, 0}, {}},
                             .angular_velocity = {0, 0.8, 0}},
                    .shapes = {},
                    .color = 0xadb5bd};
    cross.shapes.push_back({.geometry = Box{{4.5, 0.25, 0.12}}});
    cross.shapes.push_back({.geometry = Box{{0.12, 0.25, 4.5}}});
    scene.bodies.push_back(cross);
    Random random(8);
    for (int i = 0; i < 60; i++) {
        const double x = random.in(-2.6, 2.6), z = random.in(-2.6, 2.6);
        SceneBody ball =
            colored(dynamic_body(i % 2 == 0 ? "red" : "blue", {x, 7 + 0.25 * i, z}, Sphere{0.2}),
                    i % 2 == 0 ? 0xef4444 : 0x3b82f6);
        ball.shapes[0].filter.category = i % 2 == 0 ? red : blue;
        ball.shapes[0].material = {.friction = 0.4, .restitution = 0.2, .rolling_friction = 0.004};
        ball.shapes[0].report_stays = i == 0;
        scene.bodies.push_back(ball);
    }
    return scene;
}

SceneDescription locked() {
    SceneDescription scene{.bodies = {ground()}};
    for (int k = 0; k < 5; k++) {
        SceneBody piston =
            colored(dynamic_body("piston", {-4 + 2.0 * k, 0.6 + 0.4 * k, -2}, Box{{0.6, 0.5, 0.6}}),
                    0x4f86c6);
        piston.body.locks = static_cast<AxisLocks>(lock_x | lock_z | lock_rotation_x |
                                                   lock_rotation_y | lock_rotation_z);
        scene.bodies.push_back(piston);
        SceneBody slider = colored(
            dynamic_body("slider", {-4 + 2.0 * k, 0.3, 1}, Box{{0.4, 0.28, 0.4}}), 0x81b29a);
        slider.body.locks =
            static_cast<AxisLocks>(lock_z | lock_rotation_x | lock_rotation_y | lock_rotation_z);
        slider.body.linear_velocity = {k % 2 == 0 ? 2.0 : -2.0, 0, 0};
        slider.shapes[0].material = {.friction = 0.02, .restitution = 0.9};
        scene.bodies.push_back(slider);
        SceneBody wheel = colored(dynamic_body("wheel", {-4 + 2.0 * k, 2.2, 4}, Cylinder{0.8, 0.1},
                                               from_axis_angle({1, 0, 0}, pi / 2)),
                                  0xe07a5f);
        wheel.body.locks =
            static_cast<AxisLocks>(lock_x | lock_y | lock_z | lock_rotation_x | lock_rotation_y);
        wheel.body.angular_velocity = {0, 0, 2.0 + k};
        wheel.body.sleep_allowed = false;
        scene.bodies.push_back(wheel);
    }
    for (int i = 0; i < 20; i++)
        scene.bodies.push_back(colored(
            dynamic_body("ball", {-4.4 + 0.45 * i, 4 + 0.3 * (i % 5), i % 2 == 0 ? -2.0 : 4.0},
                         Sphere{0.2}),
            0xf2cc8f));
    return scene;
}

SceneDescription flatland() {
    SceneDescription scene;
    scene.world.planar = true;
    scene.bodies.push_back(fixed_box("ground", {0, -0.5, 0}, {30, 0.5, 0.5}));
    for (const double side : {-1.0, 1.0})
        scene.bodies.push_back(fixed_box("wall", {side * 14, 3, 0}, {0.5, 3, 0.5}));
    for (int i = 0; i < 12; i++)
        for (int j = 0; j < 12 - i; j++)
            scene.bodies.push_back(
                colored(dynamic_body("box", {-4 + (j - (11 - i) / 2.0) * 0.63, 0.3 + 0.6 * i, 0},
                                     Box{{0.3, 0.3, 0.3}}),
                        i % 2 == 0 ? 0xe9c46a : 0xf4a261));
    Random random(14);
    for (int i = 0; i < 50; i++) {
        const double r = random.in(0.15, 0.35), x = random.in(4, 11);
        const Geometry kinds[] = {Sphere{r}, Capsule{0.6 * r, r}, Box{{r, 0.6 * r, 0.3}}};
        scene.bodies.push_back(colored(dynamic_body("piece", {x, 1 + 0.35 * i, 0}, kinds[i % 3],
                                                    from_axis_angle({0, 0, 1}, x)),
                                       i % 3 == 0 ? 0x457b9d : (i % 3 == 1 ? 0x9b5de5 : 0x2a9d8f)));
        scene.bodies.back().shapes[0].material.rolling_friction = 0.004;
    }
    SceneBody ball = colored(dynamic_body("ball", {3, 9, 0}, Sphere{0.8}), 0xe63946);
    ball.body.linear_velocity = {-9, 2, 0};
    scene.bodies.push_back(ball);
    return scene;
}

}  // namespace jostle::scenes
