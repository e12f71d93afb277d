// SPDX-License-Identifier: MIT
//
// Water with buoyancy: boats to drive, crates and barrels, buoys on chains.
#include <string>
#include <vector>

#include "jostle/physics/hull.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double sea_bed = -5;  // m

// Flat at the bottom and blunt at the stern, with the bow at -z.
Geometry boat_hull() {
    std::vector<Vec3> points;
    for (const double side : {-1.0, 1.0}) {
        points.push_back({side * 1.1, 0.5, 2.6});
        points.push_back({side * 0.9, -0.45, 2.5});
        points.push_back({side * 1.1, 0.5, -0.8});
        points.push_back({side * 0.85, -0.45, -1.2});
        points.push_back({side * 0.1, 0.62, -3.1});
    }
    points.push_back({0, -0.3, -2.5});
    const auto hull = build_hull(points);
    return hull.ok() ? Geometry(Hull{*hull}) : Geometry(Box{{1, 0.45, 2.6}});
}

SceneBody boat(const std::string& name, Vec3 at, std::uint32_t color) {
    SceneBody body =
        colored(dynamic_body(name, at, boat_hull(), from_axis_angle({0, 1, 0}, pi)), color);
    body.shapes[0].density = 180;
    body.shapes.push_back(
        {.geometry = Box{{0.7, 0.5, 0.8}}, .pose = {{0, 1.0, 0.9}, {}}, .density = 40});
    body.shapes.push_back(
        {.geometry = Cylinder{0.12, 0.35}, .pose = {{0, 1.8, 1.1}, {}}, .density = 40});
    // Low ballast rights the boat from any roll.
    body.shapes.push_back(
        {.geometry = Box{{0.4, 0.06, 1.5}}, .pose = {{0, -0.4, 0.3}, {}}, .mass = 500});
    return body;
}

void add_quay(SceneDescription& scene) {
    scene.bodies.push_back(
        colored(fixed_box("sea bed", {0, sea_bed - 1, 0}, {90, 1, 90}), 0x264653));
    scene.bodies.push_back(colored(fixed_box("quay", {-4, -2, -19}, {22, 3, 3}), 0x8d99ae));
    scene.bodies.push_back(colored(fixed_box("mole", {20, -2, -6}, {2, 3.3, 16}), 0x8d99ae));
    SceneBody tower = fixed_box("lighthouse", {20, 4.3, 8}, {1, 3, 1});
    tower.shapes[0].geometry = Cylinder{0.9, 3};
    scene.bodies.push_back(colored(tower, 0xf1faee));
    SceneBody lamp = fixed_box("lamp", {20, 8.1, 8}, {1, 1, 1});
    lamp.shapes[0].geometry = Cone{1.3, 0.8};
    scene.bodies.push_back(colored(lamp, 0xd62828));
    for (int k = 0; k < 4; k++) {
        SceneBody shed = fixed_box("shed", {-20 + 9.0 * k, 2.2, -20}, {2.6, 1.2, 1.4});
        scene.bodies.push_back(colored(shed, k % 2 ? 0xb5651d : 0x9c6644));
    }
}

void add_flotsam(SceneDescription& scene) {
    Random random(11);
    for (int k = 0; k < 18; k++) {
        const Vec3 at{random.in(-20, 15), random.in(1, 4), random.in(-3, 14)};
        const bool crate = k % 2 == 0;
        SceneBody body = crate ? dynamic_body("crate", at, Box{{0.5, 0.4, 0.6}})
                               : dynamic_body("barrel", at, Cylinder{0.35, 0.5});
        body.shapes[0].density = crate ? random.in(150, 700) : random.in(80, 500);
        scene.bodies.push_back(colored(body, crate ? 0xe9c46a : 0x2a9d8f));
    }
}

// Buoys that mark a slalom course.
void add_buoys(SceneDescription& scene) {
    constexpr double reach = 5.6;  // m of chain
    for (int k = 0; k < 6; k++) {
        const double x = -15 + 6.0 * k, z = 17 + (k % 2 ? 3.5 : -3.5);
        SceneBody buoy = dynamic_body("buoy", {x, 0.3, z}, Cone{0.6, 0.7});
        buoy.shapes[0].density = 200;
        scene.bodies.push_back(colored(buoy, k % 2 ? 0x2b9348 : 0xd62828));
        join(scene, "chain", 0, scene.bodies.size() - 1, {{x, sea_bed, z}, {}},
             DistanceJoint{.min_length = 0, .max_length = reach});
        scene.joints.back().joint.frame_b = {{0, -0.7, 0}, {}};
    }
}

}  // namespace

// Boats, crates and barrels on a swell, between a quay and a mole; buoys on chains.
SceneDescription harbour() {
    SceneDescription scene;
    add_quay(scene);
    constexpr std::uint32_t colors[] = {0xe76f51, 0x3a86ff, 0xf4a261, 0x8338ec, 0xef476f};
    SceneModule boats{.tag = "boat", .settings = {}, .bodies = {}, .state = {}};
    for (int k = 0; k < 5; k++) {
        const std::string name = k == 0 ? "boat" : "boat" + std::to_string(k + 1);
        boats.bodies[name] = scene.bodies.size();
        scene.bodies.push_back(boat(name, {-18 + 7.5 * k, 0.4, -10.5}, colors[k]));
    }
    add_flotsam(scene);
    add_buoys(scene);
    scene.modules.push_back({.tag = "fields",
                             .settings = {{"waves_level", 0},
                                          {"wave1_amplitude", 0.25},
                                          {"wave1_length", 16},
                                          {"wave1_heading", 0.4},
                                          {"wave2_amplitude", 0.13},
                                          {"wave2_length", 10},
                                          {"wave2_heading", -0.5},
                                          {"wave2_phase", 1},
                                          {"turbulence_wind_x", 2},
                                          {"turbulence_speed", 1.5},
                                          {"turbulence_scale", 8},
                                          {"turbulence_center_y", 20},
                                          {"turbulence_half_y", 19.9}},
                             .bodies = {},
                             .state = {}});
    scene.modules.push_back(boats);
    return scene;
}

}  // namespace jostle::scenes
