// SPDX-License-Identifier: MIT
//
// Jointed bodies: ragdolls on stairs, a bridge and a wrecking ball, a workshop with motors.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// Rotates a joint's x axis to a direction in the world.
Quat facing(Vec3 x) {
    const Vec3 n = normalized(x), axis = cross(Vec3{1, 0, 0}, n);
    if (length(axis) < 1e-9) return n.x > 0 ? Quat{} : from_axis_angle({0, 1, 0}, pi);
    return from_axis_angle(axis, arc_tangent(length(axis), n.x));
}

// Eleven bones of a person, 1.7 m tall, who stands at `at`.
void add_ragdoll(SceneDescription& scene, Vec3 at, std::uint32_t color) {
    const std::size_t first = scene.bodies.size();
    const auto bone = [&](Vec3 offset, Geometry geometry, Quat rotation = {}) {
        SceneBody body = colored(dynamic_body("bone", at + offset, geometry, rotation), color);
        body.shapes[0].material = {.friction = 0.6, .restitution = 0};
        body.body.angular_damping = 0.5;
        scene.bodies.push_back(body);
    };
    const Quat across = from_axis_angle({0, 0, 1}, pi / 2);
    bone({0, 1.0, 0}, Box{{0.16, 0.12, 0.1}});            // 0 pelvis
    bone({0, 1.32, 0}, Box{{0.17, 0.18, 0.1}});           // 1 chest
    bone({0, 1.66, 0}, Sphere{0.12});                     // 2 head
    bone({-0.1, 0.66, 0}, Capsule{0.07, 0.14});           // 3 thighs
    bone({0.1, 0.66, 0}, Capsule{0.07, 0.14});            // 4
    bone({-0.1, 0.25, 0}, Capsule{0.06, 0.14});           // 5 shins
    bone({0.1, 0.25, 0}, Capsule{0.06, 0.14});            // 6
    bone({-0.36, 1.42, 0}, Capsule{0.05, 0.1}, across);   // 7 upper arms
    bone({0.36, 1.42, 0}, Capsule{0.05, 0.1}, across);    // 8
    bone({-0.64, 1.42, 0}, Capsule{0.045, 0.1}, across);  // 9 forearms
    bone({0.64, 1.42, 0}, Capsule{0.045, 0.1}, across);   // 10
    const auto cone = [&](std::size_t a, std::size_t b, Vec3 offset, Vec3 along, double swing,
                          double twist) {
        join(
            scene, "cone", first + a, first + b, {at + offset, facing(along)},
            ConeTwistJoint{.swing = swing, .twist = {true, -twist, twist}, .friction_torque = 0.5});
    };
    cone(0, 1, {0, 1.13, 0}, {0, 1, 0}, 0.5, 0.4);
    cone(1, 2, {0, 1.53, 0}, {0, 1, 0}, 0.6, 0.8);
    const auto hinge = [&](std::size_t a, std::size_t b, Vec3 offset, Vec3 axis, double lower,
                           double upper) {
        // The hinge rotates about the z axis of its frame.
        const Quat turn =
            axis.x != 0 ? from_axis_angle({0, 1, 0}, pi / 2) : from_axis_angle({1, 0, 0}, -pi / 2);
        join(scene, "hinge", first + a, first + b, {at + offset, turn},
             HingeJoint{.limit = {true, lower, upper}});
    };
    for (const double side : {-1.0, 1.0}) {
        const std::size_t k = side < 0 ? 0 : 1;
        cone(0, 3 + k, {0.1 * side, 0.86, 0}, {0, -1, 0}, 0.9, 0.3);
        hinge(3 + k, 5 + k, {0.1 * side, 0.46, 0}, {1, 0, 0}, -0.05, 2.2);
        cone(1, 7 + k, {0.2 * side, 1.42, 0}, {side, 0, 0}, 1.2, 0.5);
        hinge(7 + k, 9 + k, {0.5 * side, 1.42, 0}, {0, 1, 0}, side < 0 ? -2.2 : -0.05,
              side < 0 ? 0.05 : 2.2);
    }
}

}  // namespace

SceneDescription ragdolls() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{13, 9, 15}, {-1, 3.5, 0}};
    for (int k = 0; k < 8; k++)
        scene.bodies.push_back(
            colored(fixed_box("step", {-4 + k * 0.8, 0.2 * (8 - k), 0}, {0.4, 0.2 * (8 - k), 4}),
                    0x8d99ae));
    const std::uint32_t colors[] = {0xe07a5f, 0x3d405b, 0x81b29a, 0xf2cc8f};
    for (int i = 0; i < 12; i++)
        add_ragdoll(scene, {-3.4 + (i / 4) * 1.4, 4.2 + 1.9 * (i / 4), (i % 4 - 1.5) * 1.8},
                    colors[i % 4]);
    return scene;
}

SceneDescription bridge() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{-15, 9, 20}, {0, 3.5, 3}};
    const std::size_t left = scene.bodies.size();
    scene.bodies.push_back(fixed_box("pier", {-7, 1.5, 0}, {1, 1.5, 1.2}));
    const std::size_t right = scene.bodies.size();
    scene.bodies.push_back(fixed_box("pier", {7, 1.5, 0}, {1, 1.5, 1.2}));
    std::size_t previous = left;
    const Quat along_z{};  // hinges rotate about z: across the bridge
    for (int k = 0; k < 20; k++) {
        const double x = -5.7 + 0.6 * k;
        scene.bodies.push_back(
            colored(dynamic_body("plank", {x, 2.95, 0}, Box{{0.28, 0.05, 1}}), 0xa47148));
        scene.bodies.back().body.angular_damping = 0.3;
        join(scene, "hinge", previous, scene.bodies.size() - 1, {{x - 0.3, 2.95, 0}, along_z},
             HingeJoint{});
        previous = scene.bodies.size() - 1;
    }
    join(scene, "hinge", previous, right, {{6, 2.95, 0}, along_z}, HingeJoint{});
    for (int k = 0; k < 6; k++)
        scene.bodies.push_back(colored(
            dynamic_body("cargo", {-2.5 + k, 3.6, (k % 3 - 1) * 0.4}, Box{{0.25, 0.25, 0.25}}),
            0xe9c46a));

    // A chain of capsules with an iron ball, held to the side.
    previous = scene.bodies.size();
    scene.bodies.push_back(fixed_box("hook", {0, 9, 8}, {0.3, 0.1, 0.3}));
    const Quat lying = from_axis_angle({1, 0, 0}, pi / 2);
    for (int k = 0; k < 10; k++) {
        scene.bodies.push_back(colored(
            dynamic_body("link", {0, 8.9, 8.3 + 0.5 * k}, Capsule{0.08, 0.17}, lying), 0x6c757d));
        scene.bodies.back().shapes[0].density = 4000;
        join(scene, "link", previous, scene.bodies.size() - 1, {{0, 8.9, 8.05 + 0.5 * k}, {}},
             BallJoint{});
        previous = scene.bodies.size() - 1;
    }
    scene.bodies.push_back(colored(dynamic_body("wrecker", {0, 8.9, 13.5}, Sphere{0.6}), 0x343a40));
    scene.bodies.back().shapes[0].density = 5000;
    join(scene, "link", previous, scene.bodies.size() - 1, {{0, 8.9, 13.05}, {}}, BallJoint{});

    // Boards fixed to each other and to posts, with joints that break at 6 kN.
    const std::size_t post = scene.bodies.size();
    scene.bodies.push_back(fixed_box("post", {-1.9, 2, 4}, {0.1, 2, 0.1}));
    scene.bodies.push_back(fixed_box("post", {1.9, 2, 4}, {0.1, 2, 0.1}));
    for (int row = 0; row < 5; row++)
        for (int k = 0; k < 3; k++) {
            const double x = -1.2 + 1.2 * k, y = 0.35 + 0.7 * row;
            scene.bodies.push_back(
                colored(dynamic_body("board", {x, y, 4}, Box{{0.59, 0.34, 0.06}}), 0xb5533c));
            const std::size_t self = scene.bodies.size() - 1;
            join(scene, "board", k == 0 ? post : self - 1, self, {{x - 0.6, y, 4}, {}},
                 FixedJoint{});
            scene.joints.back().joint.break_force = 6000;
            if (k < 2) continue;
            join(scene, "board", self, post + 1, {{x + 0.6, y, 4}, {}}, FixedJoint{});
            scene.joints.back().joint.break_force = 6000;
        }
    return scene;
}

SceneDescription workshop() {
    SceneDescription scene{.bodies = {ground()}};
    const std::size_t floor = 0;
    // A drum of eight boards driven by a motor, with balls inside.
    SceneBody drum = colored(dynamic_body("drum", {0, 2.2, 0}, Box{{0.1, 0.1, 0.1}}), 0x577590);
    drum.shapes.clear();
    for (int k = 0; k < 8; k++) {
        const double turn = k * pi / 4;
        const SinCos at = sin_cos(turn);
        drum.shapes.push_back(
            {.geometry = Box{{0.75, 0.08, 1}},
             .pose = {{1.7 * at.sin, 1.7 * at.cos, 0}, from_axis_angle({0, 0, 1}, -turn)},
             .density = 300});
    }
    for (const double side : {-1.0, 1.0})
        drum.shapes.push_back(
            {.geometry = Box{{1.4, 1.4, 0.06}}, .pose = {{0, 0, side * 1.06}, {}}, .density = 100});
    scene.bodies.push_back(drum);
    join(scene, "axle", floor, 1, {{0, 2.2, 0}, {}}, HingeJoint{.motor = {true, 1.2, 60000}});
    for (int i = 0; i < 24; i++)
        scene.bodies.push_back(colored(
            dynamic_body("ball",
                         {(i % 4 - 1.5) * 0.45, 1.5 + 0.4 * (i / 8), (i / 4 % 2 - 0.5) * 0.8},
                         i % 2 == 0 ? Geometry(Sphere{0.18}) : Geometry(Box{{0.15, 0.15, 0.15}})),
            i % 2 == 0 ? 0xf94144 : 0xf9c74f));
    // Swing doors closed by springs.
    for (int k = 0; k < 3; k++) {
        const double x = 5 + 1.6 * k;
        scene.bodies.push_back(
            colored(dynamic_body("door", {x + 0.7, 1.05, -3}, Box{{0.65, 1, 0.04}}), 0x90be6d));
        scene.bodies.back().body.angular_velocity = {0, 2.0 + k, 0};
        join(scene, "door", floor, scene.bodies.size() - 1,
             {{x, 1.05, -3}, from_axis_angle({1, 0, 0}, -pi / 2)},
             HingeJoint{.limit = {true, -1.4, 1.4}, .spring = {0.5, 0.2}});
    }
    // Weights on a rod, on a rope and on a spring.
    scene.bodies.push_back(fixed_box("beam", {-7, 5, 0}, {0.1, 0.1, 4}));
    const std::size_t beam = scene.bodies.size() - 1;
    const auto hang = [&](const char* name, double z, Vec3 offset, const DistanceJoint& kind) {
        scene.bodies.push_back(
            colored(dynamic_body(name, Vec3{-7, 4.9, z} + offset, Sphere{0.3}), 0x277da1));
        SceneJoint joint{
            .name = name, .body_a = beam, .body_b = scene.bodies.size() - 1, .joint = {}};
        joint.joint.frame_a = {{0, -0.1, z}, {}};
        joint.joint.kind = kind;
        scene.joints.push_back(joint);
    };
    hang("rod", -3, {1.5, -1.5, 0},
         {.min_length = square_root(4.5), .max_length = square_root(4.5)});
    hang("rope", 0, {0.8, -0.3, 0}, {.min_length = 0, .max_length = 2.5});
    hang("spring", 3, {0, -2, 0},
         {.min_length = 0.5, .max_length = 4, .spring = {0.8, 0.03}, .rest_length = 1.5});
    return scene;
}

}  // namespace jostle::scenes
