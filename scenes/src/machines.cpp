// SPDX-License-Identifier: MIT
//
// Joints of machines: a car on wheels, gears that drive a rack, a pulley, a bead on a wire, a lift
// on a slider, a gimbal, and a ball on a grab joint.
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// Rotates the z axis of a frame to the y axis of the world
const Quat upright = from_axis_angle({1, 0, 0}, -pi / 2);

std::size_t add(SceneDescription& scene, const SceneBody& body, std::uint32_t color) {
    scene.bodies.push_back(colored(body, color));
    return scene.bodies.size() - 1;
}

// Four sprung wheels; the front ones are steered, the rear ones driven.
void add_car(SceneDescription& scene, Vec3 at) {
    const std::size_t chassis =
        add(scene, dynamic_body("chassis", at + Vec3{0, 0.8, 0}, Box{{1.2, 0.2, 0.5}}), 0xd62828);
    scene.bodies[chassis].shapes[0].density = 400;
    for (int k = 0; k < 4; k++) {
        const bool front = k < 2;
        const Vec3 position = at + Vec3{front ? 0.9 : -0.9, 0.4, k % 2 == 0 ? 0.7 : -0.7};
        const std::size_t wheel =
            add(scene, dynamic_body("wheel", position, Sphere{0.4}), 0x222222);
        scene.bodies[wheel].shapes[0].material.friction = 1;
        WheelJoint kind{.suspension = {2.5, 0.5}, .travel = {true, -0.2, 0.2}};
        if (front)
            kind.steering = 0.25;
        else
            kind.motor = {true, -8, 300};
        join(scene, "suspension", chassis, wheel, {position, {}}, kind);
    }
}

// A wheel that oscillates on a spring, one of twice its size, and a rack that they move up and
// down.
void add_gears(SceneDescription& scene, std::size_t floor, Vec3 at) {
    const auto cog = [&](Vec3 offset, double radius, std::uint32_t color, const HingeJoint& hinge) {
        const std::size_t body = add(scene,
                                     dynamic_body("cog", at + offset, Cylinder{radius, 0.1},
                                                  from_axis_angle({1, 0, 0}, pi / 2)),
                                     color);
        // A peg makes the rotation visible.
        scene.bodies[body].shapes.push_back(
            {.geometry = Box{{0.08, 0.2, 0.08}}, .pose = {{radius * 0.7, 0, 0}, {}}});
        join(scene, "axle", floor, body, {at + offset, {}}, hinge);
        return body;
    };
    const std::size_t small =
        cog({0, 2, 0}, 0.4, 0x277da1, HingeJoint{.spring = {0.25, 0}, .spring_angle = 1.4});
    const std::size_t large = cog({1.25, 2, 0}, 0.8, 0x4d908e, HingeJoint{});
    join(scene, "gear", small, large, {at + Vec3{0.6, 2, 0}, {}}, GearJoint{.ratio = 2});
    const std::size_t rack =
        add(scene, dynamic_body("rack", at + Vec3{2.3, 2, 0}, Box{{0.15, 1, 0.15}}), 0xf9c74f);
    join(scene, "rail", floor, rack, {at + Vec3{2.3, 2, 0}, upright},
         SliderJoint{.limit = {true, -10, 10}});
    join(scene, "rack", large, rack, {at + Vec3{2.3, 2, 0}, {}}, RackJoint{.radius = -0.8});
    // The rack moves along the z axis of its frame, regardless of the direction of the pinion's
    // axis.
    scene.joints.back().joint.frame_b.rotation = upright;
}

void add_pulley(SceneDescription& scene, Vec3 at) {
    add(scene, fixed_box("gallows", at + Vec3{0, 6.2, 0}, {1.4, 0.1, 0.2}), 0x6c757d);
    const auto weight = [&](double x, double density, std::uint32_t color) {
        const std::size_t body =
            add(scene, dynamic_body("weight", at + Vec3{x, 3, 0}, Box{{0.35, 0.35, 0.35}}), color);
        scene.bodies[body].shapes[0].density = density;
        return body;
    };
    const std::size_t heavy = weight(-1, 1200, 0x577590), light = weight(1, 1000, 0x90be6d);
    SceneJoint joint{.name = "pulley", .body_a = heavy, .body_b = light, .joint = {}};
    joint.joint.frame_a = joint.joint.frame_b = {{0, 0.35, 0}, {}};
    joint.joint.kind =
        PulleyJoint{.point_a = at + Vec3{-1, 6, 0}, .point_b = at + Vec3{1, 6, 0}, .length = 5.3};
    scene.joints.push_back(joint);
}

// A bead that oscillates in a valley.
void add_wire(SceneDescription& scene, Vec3 at) {
    PathJoint path{.points = {}};
    for (int k = -4; k <= 4; k++)
        path.points.push_back(at + Vec3{0.7 * k, 1 + 0.12 * k * k, k % 2 == 0 ? 0.2 : -0.2});
    const std::size_t bead =
        add(scene, dynamic_body("bead", path.points.front(), Sphere{0.2}), 0xf3722c);
    SceneJoint joint{.name = "wire", .body_a = world_body, .body_b = bead, .joint = {}};
    joint.joint.kind = path;
    scene.joints.push_back(joint);
}

}  // namespace

SceneDescription machines() {
    SceneDescription scene{.bodies = {ground()}};
    scene.view = SceneView{{2, 9, 21}, {0.5, 2, 1}};
    const std::size_t floor = 0;
    add_car(scene, {0, 0, 6});
    add_gears(scene, floor, {-8, 0, 0});
    add_pulley(scene, {-2, 0, -3});
    add_wire(scene, {5, 0, -3});

    // A lift supported by a spring, with a load that it throws.
    const std::size_t lift =
        add(scene, dynamic_body("lift", {2, 1, 0}, Box{{0.8, 0.1, 0.8}}), 0x43aa8b);
    join(scene, "lift", floor, lift, {{2, 1, 0}, upright},
         SliderJoint{.limit = {true, -0.8, 2}, .spring = {1, 0.02}, .spring_travel = 0.5});
    for (int k = 0; k < 4; k++)
        add(scene,
            dynamic_body("load", {1.7 + 0.6 * (k % 2), 1.4, -0.3 + 0.6 * (k / 2)},
                         Box{{0.2, 0.2, 0.2}}),
            0xe9c46a);

    // A rotor in a gimbal: two rotations are free, the third has a motor.
    const std::size_t rotor =
        add(scene, dynamic_body("rotor", {8, 3, 0}, Cylinder{0.8, 0.1}), 0x9b5de5);
    SixDofAxes gimbal;
    gimbal.rotation_x = {.free = true, .spring = {0.5, 0.1}};
    gimbal.rotation_y = {.free = true, .motor = {true, 12, 2000}};
    gimbal.rotation_z = {.free = true, .limit = {true, -0.6, 0.6}};
    join(scene, "gimbal", floor, rotor, {{8, 3, 0}, {}}, SixDofJoint{gimbal});
    scene.bodies[rotor].body.angular_velocity = {0.5, 0, 0.5};

    // Grabbed at a point away from its centre.
    const std::size_t held =
        add(scene, dynamic_body("held", {8, 2, 6}, Box{{0.4, 0.2, 0.3}}), 0x00bbf9);
    SceneJoint hand{.name = "hand", .body_a = world_body, .body_b = held, .joint = {}};
    hand.joint.frame_a = {{8, 3, 6}, {}};
    hand.joint.frame_b = {{0.3, 0.2, 0}, {}};
    hand.joint.kind = GrabJoint{.spring = {2, 0.3}, .max_force = 5000, .angular_damping = 1};
    scene.joints.push_back(hand);
    return scene;
}

}  // namespace jostle::scenes
