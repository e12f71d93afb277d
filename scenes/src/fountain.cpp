// SPDX-License-Identifier: MIT
//
// Particles: a fountain on a hill that pushes bodies, hail, smoke that clients simulate, a rope.
#include <cmath>
#include <string>

#include "jostle/physics/height_field.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// 40 m square: a hill of 3 m with a basin on top, and a rim that contains loose bodies.
double hill_height(double x, double z) {
    const double r = square_root(x * x + z * z);
    const double hill = r < 10 ? 1.5 * (1 + sin_cos(pi * r / 10).cos) : 0;
    const double basin = r < 2 ? -0.4 * (1 + sin_cos(pi * r / 2).cos) : 0;
    const double rim = r > 14 ? 0.15 * (r - 14) * (r - 14) : 0;
    return hill + basin + rim;
}

Geometry fountain_hill() {
    constexpr std::uint32_t samples = 81;
    HeightGrid grid{.columns = samples, .rows = samples, .spacing_x = 0.5, .spacing_z = 0.5};
    for (std::uint32_t r = 0; r < samples; r++)
        for (std::uint32_t c = 0; c < samples; c++)
            grid.heights.push_back(hill_height(0.5 * c - 20, 0.5 * r - 20));
    return HeightField{*build_height_field(std::move(grid))};
}

// A wheel with eight paddles on a hinge, in the jet at its rim.
void add_mill(SceneDescription& scene) {
    const Vec3 hub{2.6, 5.2, 0};
    SceneBody wheel = colored(dynamic_body("mill", hub, Box{{0.15, 0.15, 0.5}}), 0x9c6644);
    for (int k = 0; k < 8; k++) {
        const Quat turn = from_axis_angle({0, 0, 1}, k * pi / 4);
        wheel.shapes.push_back({.geometry = Box{{0.5, 0.03, 0.45}},
                                .pose = {rotate(turn, {0.7, 0, 0}), turn},
                                .density = 30});
    }
    wheel.shapes[0].density = 30;
    scene.bodies.push_back(wheel);
    join(scene, "axle", 0, scene.bodies.size() - 1, {hub, {}}, HingeJoint{});
}

void add_loose_bodies(SceneDescription& scene) {
    Random random(17);
    for (int k = 0; k < 24; k++) {
        const SinCos at = sin_cos(0.26 * k);
        const double r = random.in(2.5, 9);
        const double x = r * at.cos, z = r * at.sin;
        SceneBody body =
            k % 3 == 2
                ? dynamic_body("crate", {x, hill_height(x, z) + 0.6, z}, Box{{0.25, 0.25, 0.25}})
                : dynamic_body("ball", {x, hill_height(x, z) + 0.6, z}, Sphere{0.3});
        body.shapes[0].density = 25;
        body.shapes[0].material = {.friction = 0.5, .restitution = 0.4, .rolling_friction = 0.02};
        scene.bodies.push_back(colored(body, k % 3 == 2 ? 0xe9c46a : 0xf4f1de));
    }
}

using Settings = std::map<std::string, double>;

// Water that pushes bodies.
Settings jet() {
    return {{"count_max", 3000},
            {"mass", 0.02},
            {"radius", 0.04},
            {"quadratic_drag", 0.02},
            {"restitution", 0.2},
            {"friction", 0.1},
            {"color", 0x4aa3df},
            {"emitter_shape", 1},
            {"emitter_position_y", 2.6},
            {"emitter_direction_x", 0.16},
            {"emitter_direction_y", 1},
            {"emitter_radius", 0.15},
            {"emitter_rate", 800},
            {"emitter_speed", 9},
            {"emitter_speed_spread", 0.08},
            {"emitter_cone", 0.14},
            {"emitter_lifetime", 3.6},
            {"emitter_lifetime_spread", 0.1},
            {"flow_speed", 1},
            {"flow_scale", 3}};
}

// Balls that bounce off each other.
Settings hail() {
    return {{"count_max", 300},
            {"mass", 0.05},
            {"radius", 0.1},
            {"collide_particles", 1},
            {"restitution", 0.6},
            {"friction", 0.4},
            {"color", 0xe0f0ff},
            {"emitter_shape", 2},
            {"emitter_position_x", -6},
            {"emitter_position_y", 9},
            {"emitter_half_extents_x", 2},
            {"emitter_half_extents_y", 0.2},
            {"emitter_half_extents_z", 2},
            {"emitter_rate", 20},
            {"emitter_speed", 0},
            {"emitter_lifetime", 12}};
}

// Smoke that clients simulate; it costs the server nothing.
Settings smoke() {
    return {{"cosmetic", 1},
            {"count_max", 1500},
            {"gravity_scale", -0.08},
            {"linear_drag", 2},
            {"color", 0x707070},
            {"emitter_shape", 3},
            {"emitter_position_x", 7},
            {"emitter_position_y", 1.2},
            {"emitter_position_z", 7},
            {"emitter_radius", 0.3},
            {"emitter_rate", 150},
            {"emitter_speed", 0.5},
            {"emitter_cone", 0.6},
            {"emitter_lifetime", 6},
            {"emitter_lifetime_spread", 0.4},
            {"flow_wind_x", 0.4},
            {"flow_speed", 0.7},
            {"flow_scale", 1.5},
            {"flow_walls1_normal_y", 1},
            {"planes1_normal_y", 1}};
}

// A rope of stiff springs that the jet swings.
Settings rope() {
    Settings settings = {{"integrator", 2},  {"substeps", 2},      {"mass", 0.05},
                         {"radius", 0.05},   {"linear_drag", 0.3}, {"collide_particles", 1},
                         {"color", 0xd62828}};
    for (int k = 0; k < 20; k++) {
        const std::string particle = "particles" + std::to_string(k + 1);
        const std::string spring = "springs" + std::to_string(k + 1);
        settings[particle + "_position_x"] = -1 - 0.15 * (k + 1);
        settings[particle + "_position_y"] = 7;
        settings[spring + "_from"] = k;
        settings[spring + "_to"] = k;
        settings[spring + "_anchor_x"] = -1;
        settings[spring + "_anchor_y"] = 7;
        settings[spring + "_rest_length"] = 0.15;
        settings[spring + "_stiffness"] = 2000;
        settings[spring + "_damping"] = 1;
    }
    return settings;
}

}  // namespace

SceneDescription fountain() {
    SceneDescription scene;
    SceneBody hill{
        .name = "hill", .body = {.type = BodyType::static_body}, .shapes = {}, .color = 0x6a994e};
    hill.shapes.push_back({.geometry = fountain_hill(), .material = {.friction = 0.6}});
    scene.bodies.push_back(hill);
    add_mill(scene);
    add_loose_bodies(scene);
    SceneModule particles{.tag = "particles", .settings = {}, .bodies = {}, .state = {}};
    for (const Settings& group : {jet(), hail(), smoke(), rope()})
        particles.objects.push_back({.list = "groups", .settings = group, .bodies = {}});
    scene.modules.push_back(particles);
    return scene;
}

}  // namespace jostle::scenes
