// SPDX-License-Identifier: MIT
#include "speed/ragdoll.h"

namespace jostle::bench {
namespace {

using physics::Quat;
using physics::Vec3;

constexpr double degree = 0.01745329252;  // as the scene's definition has it

struct Part {
    Vec3 center;
    double radius, half_length;
    bool sideways;  // its axis is x, not y
};

constexpr Part parts[] = {
    {{0, 1.00, 0}, 0.11, 0.08, true},       // 0 pelvis
    {{0, 1.30, 0}, 0.13, 0.10, false},      // 1 chest
    {{0, 1.66, 0}, 0.10, 0.04, false},      // 2 head
    {{0.33, 1.42, 0}, 0.05, 0.12, true},    // 3 left upper arm
    {{-0.33, 1.42, 0}, 0.05, 0.12, true},   // 4 right upper arm
    {{0.64, 1.42, 0}, 0.04, 0.13, true},    // 5 left lower arm
    {{-0.64, 1.42, 0}, 0.04, 0.13, true},   // 6 right lower arm
    {{0.10, 0.69, 0}, 0.07, 0.16, false},   // 7 left upper leg
    {{-0.10, 0.69, 0}, 0.07, 0.16, false},  // 8 right upper leg
    {{0.10, 0.24, 0}, 0.06, 0.18, false},   // 9 left lower leg
    {{-0.10, 0.24, 0}, 0.06, 0.18, false},  // 10 right lower leg
};

struct Link {
    SceneJointKind kind;
    std::uint32_t a, b;
    Vec3 anchor, axis, normal;
    double swing, lower, upper;  // degrees
};

constexpr SceneJointKind cone = SceneJointKind::cone_twist, hinge = SceneJointKind::hinge;
constexpr Link links[] = {
    {cone, 0, 1, {0, 1.12, 0}, {0, 1, 0}, {1, 0, 0}, 30, -20, 20},     // waist
    {cone, 1, 2, {0, 1.54, 0}, {0, 1, 0}, {1, 0, 0}, 35, -45, 45},     // neck
    {cone, 1, 3, {0.17, 1.42, 0}, {1, 0, 0}, {0, 0, 1}, 80, -45, 45},  // shoulders
    {cone, 1, 4, {-0.17, 1.42, 0}, {-1, 0, 0}, {0, 0, 1}, 80, -45, 45},
    {hinge, 3, 5, {0.48, 1.42, 0}, {0, 1, 0}, {1, 0, 0}, 0, -120, 5},  // elbows
    {hinge, 4, 6, {-0.48, 1.42, 0}, {0, 1, 0}, {1, 0, 0}, 0, -5, 120},
    {cone, 0, 7, {0.10, 0.89, 0}, {0, -1, 0}, {1, 0, 0}, 60, -20, 20},  // hips
    {cone, 0, 8, {-0.10, 0.89, 0}, {0, -1, 0}, {1, 0, 0}, 60, -20, 20},
    {hinge, 7, 9, {0.10, 0.46, 0}, {1, 0, 0}, {0, 1, 0}, 0, -5, 120},  // knees
    {hinge, 8, 10, {-0.10, 0.46, 0}, {1, 0, 0}, {0, 1, 0}, 0, -5, 120},
};

}  // namespace

void add_ragdoll(SceneDescription& scene, const physics::Transform& feet) {
    const auto first = static_cast<std::uint32_t>(scene.bodies.size());
    const Quat y_to_x = physics::from_axis_angle({0, 0, 1}, -physics::pi / 2);
    for (const Part& part : parts)
        scene.bodies.push_back(
            {.form = physics::Capsule{part.radius, part.half_length},
             .pose = compose(feet, {part.center, part.sideways ? y_to_x : Quat{}})});
    for (const Link& link : links)
        scene.joints.push_back({.kind = link.kind,
                                .a = first + link.a,
                                .b = first + link.b,
                                .anchor = apply(feet, link.anchor),
                                .axis = rotate(feet.rotation, link.axis),
                                .normal = rotate(feet.rotation, link.normal),
                                .swing = link.swing * degree,
                                .lower = link.lower * degree,
                                .upper = link.upper * degree});
}

}  // namespace jostle::bench
