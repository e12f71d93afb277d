// SPDX-License-Identifier: MIT
//
// A ring road with kerbs, over a hill on one side, and a ramp. Pilots drive until a client controls
// a car.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double inside = 37, outside = 53, middle = 45;  // m, radii of the road
constexpr int sectors = 96;
constexpr double sector = 2 * pi / sectors;

double land_height(double x, double z) {
    const double hill = maximum(0, 1 - (x * x + (z - middle) * (z - middle)) / 900);
    return 2.5 * hill * hill;
}

Vec3 on_land(double radius, double angle, double lift) {
    const SinCos at = sin_cos(angle);
    const double x = radius * at.cos, z = radius * at.sin;
    return {x, land_height(x, z) + lift, z};
}

SceneBody land() {
    constexpr std::uint32_t samples = 121;
    HeightGrid grid{.columns = samples, .rows = samples, .spacing_x = 2, .spacing_z = 2};
    for (std::uint32_t r = 0; r < samples; r++)
        for (std::uint32_t c = 0; c < samples; c++)
            grid.heights.push_back(land_height(2 * (c - 60.0), 2 * (r - 60.0)));
    SceneBody body{.name = "land", .body = {.type = BodyType::static_body}, .shapes = {}};
    body.shapes.push_back({.geometry = HeightField{*build_height_field(std::move(grid))},
                           .material = {.friction = 0.6}});
    return colored(body, 0x5f7d4a);
}

// Strips on the land: bands between radii, each at a height above it.
struct Band {
    double radius, lift;
};
struct Strips {
    std::vector<Vec3> vertices = {};
    std::vector<std::array<std::uint32_t, 3>> triangles = {};

    void add(std::span<const Band> bands, double from, double to) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const double angle : {from, to})
            for (const Band& band : bands)
                vertices.push_back(on_land(band.radius, angle, band.lift));
        const auto across = static_cast<std::uint32_t>(bands.size());
        for (std::uint32_t k = first; k + 1 < first + across; k++) {
            triangles.push_back({k, k + across, k + 1});
            triangles.push_back({k + 1, k + across, k + across + 1});
        }
    }
    SceneBody body(const char* name, std::uint32_t color) const {
        SceneBody made{.name = name, .body = {.type = BodyType::static_body}, .shapes = {}};
        made.shapes.push_back(
            {.geometry = Mesh{*build_mesh(vertices, triangles)}, .material = {.friction = 0.9}});
        return colored(made, color);
    }
};

void add_road(SceneDescription& scene) {
    // The edges dip into the land, so that wheels do not catch on them.
    constexpr Band road[] = {{inside - 0.5, -0.1}, {inside, 0.06}, {41, 0.06},
                             {middle, 0.06},       {49, 0.06},     {outside, 0.06},
                             {outside + 0.5, -0.1}};
    constexpr Band inner[] = {{inside - 0.4, 0}, {inside - 0.1, 0.1}, {inside + 0.8, 0.08}};
    constexpr Band outer[] = {{outside - 0.8, 0.08}, {outside + 0.1, 0.1}, {outside + 0.4, 0}};
    constexpr Band line[] = {{inside + 0.8, 0.075}, {middle, 0.075}, {outside - 0.8, 0.075}};
    Strips asphalt, red, white, start;
    for (int k = 0; k < sectors; k++) {
        const double from = sector * k, to = sector * (k + 1);
        asphalt.add(road, from, to);
        Strips& kerb = k % 2 ? red : white;
        kerb.add(inner, from, to);
        kerb.add(outer, from, to);
    }
    start.add(line, -0.11, -0.09);
    scene.bodies.push_back(asphalt.body("road", 0x3b3d42));
    scene.bodies.push_back(red.body("kerb", 0xc1121f));
    scene.bodies.push_back(white.body("kerb", 0xf1faee));
    scene.bodies.push_back(start.body("start line", 0xffffff));
    for (const double radius : {inside - 1.2, outside + 1.2}) {
        const Vec3 foot = on_land(radius, -0.1, 0);
        scene.bodies.push_back(
            colored(fixed_box("gate", foot + Vec3{0, 2.5, 0}, {0.2, 2.5, 0.2}), 0x3a86ff));
    }
    const SinCos at = sin_cos(-0.1);
    scene.bodies.push_back(colored(fixed_box("gate", {middle * at.cos, 5, middle * at.sin},
                                             {9.6, 0.5, 0.25}, from_axis_angle({0, 1, 0}, 0.1)),
                                   0x3a86ff));
}

void add_surroundings(SceneDescription& scene) {
    for (int k = 0; k < 84; k++) {
        const bool outer = k >= 36;
        const double angle = outer ? 2 * pi * (k - 36) / 48 : 2 * pi * k / 36;
        SceneBody tyre = dynamic_body(
            "tyre", on_land(outer ? outside + 4 : inside - 4, angle, 0.17), Cylinder{0.45, 0.15});
        tyre.shapes[0].density = 90;
        scene.bodies.push_back(colored(tyre, k % 2 ? 0xf8f9fa : 0xd90429));
    }
    scene.bodies.push_back(
        colored(fixed_box("ramp", {49.5, 0.15, -17}, {2, 0.1, 4}, from_axis_angle({1, 0, 0}, 0.14)),
                0xffb703));
    Random random(5);
    for (int k = 0; k < 26; k++) {
        const double angle = random.in(0, 2 * pi),
                     radius = k % 2 ? random.in(6, 28) : random.in(62, 80),
                     size = random.in(0.7, 1.3);
        const Vec3 foot = on_land(radius, angle, 0);
        SceneBody trunk = fixed_box("tree", foot + Vec3{0, 0.6 * size, 0}, {1, 1, 1}),
                  crown = fixed_box("tree", foot + Vec3{0, 2.9 * size, 0}, {1, 1, 1});
        trunk.shapes[0].geometry = Cylinder{0.22 * size, 0.7 * size};
        crown.shapes[0].geometry = Cone{1.3 * size, 1.8 * size};
        scene.bodies.push_back(colored(trunk, 0x7f5539));
        scene.bodies.push_back(colored(crown, k % 3 ? 0x386641 : 0x6a994e));
    }
}

// A car body: low bonnet and boot, a cabin with slanted windows, and most of the mass in the floor.
SceneBody car(const std::string& name, Vec3 at, double turn) {
    SceneBody body =
        dynamic_body(name, at, Box{{0.85, 0.2, 2.05}}, from_axis_angle({0, 1, 0}, turn));
    body.shapes[0].mass = 450;
    std::vector<Vec3> cabin;
    for (const double side : {-1.0, 1.0})
        for (const Vec3 p : {Vec3{0.8, 0.2, -0.75}, Vec3{0.62, 0.62, -0.15}, Vec3{0.62, 0.62, 0.85},
                             Vec3{0.8, 0.2, 1.45}})
            cabin.push_back({side * p.x, p.y, p.z});
    const auto hull = build_hull(cabin);
    if (hull.ok()) body.shapes.push_back({.geometry = Hull{*hull}, .mass = 50});
    body.shapes.push_back(
        {.geometry = Box{{0.75, 0.03, 0.14}}, .pose = {{0, 0.46, 1.95}, {}}, .mass = 5});
    body.shapes.push_back(
        {.geometry = Box{{0.6, 0.05, 1.3}}, .pose = {{0, -0.22, 0}, {}}, .mass = 695});
    body.body.sleep_allowed = false;
    return body;
}

}  // namespace

SceneDescription race_track() {
    SceneDescription scene;
    scene.bodies.push_back(land());
    // Ground around the land, so that cars that leave it do not fall.
    scene.bodies.push_back(colored(fixed_box("plain", {0, -1.06, 0}, {400, 1, 400}), 0x5f7d4a));
    add_road(scene);
    add_surroundings(scene);
    SceneModule cars{.tag = "vehicle",
                     .settings = {{"pilot_radius", middle},
                                  {"pilot_speed", 16},
                                  {"frequency", 1.9},
                                  {"anti_roll", 20000}},
                     .bodies = {},
                     .state = {}};
    for (int k = 0; k < 6; k++) {
        // One behind the other, along the tangent: counter-clockwise seen from above.
        const double angle = 0.16 * k;
        const std::string name = k == 0 ? "car" : "car" + std::to_string(k + 1);
        cars.bodies[name] = scene.bodies.size();
        constexpr std::uint32_t colors[] = {0xe63946, 0x457b9d, 0xf4a261,
                                            0x2a9d8f, 0x8338ec, 0xffbe0b};
        scene.bodies.push_back(colored(car(name, on_land(middle, angle, 0.75), -angle), colors[k]));
    }
    scene.modules.push_back(cars);
    return scene;
}

}  // namespace jostle::scenes
