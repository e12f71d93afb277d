// SPDX-License-Identifier: MIT
//
// Uneven ground: a height field with hills and a hole, a mesh of stairs and a slide.
#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// Two long crossing waves and a bowl in the middle.
double height_at(double x, double z) {
    const double waves = 0.6 * sin_cos(0.45 * x).sin + 0.5 * sin_cos(0.38 * z + 1).sin;
    const double r2 = x * x + z * z;
    return waves + 0.02 * r2 - (r2 < 9 ? 0.6 * (1 - r2 / 9) : 0);
}

Geometry hills() {
    constexpr std::uint32_t samples = 49;
    constexpr double spacing = 0.6;
    HeightGrid grid{.columns = samples,
                    .rows = samples,
                    .spacing_x = spacing,
                    .spacing_z = spacing,
                    .heights = {},
                    .holes = std::vector<std::uint8_t>((samples - 1) * (samples - 1), 0)};
    for (std::uint32_t r = 0; r < samples; r++)
        for (std::uint32_t c = 0; c < samples; c++)
            grid.heights.push_back(height_at((c - 24.0) * spacing, (r - 24.0) * spacing));
    // A shaft in the bowl, through which bodies fall.
    for (const std::uint32_t cell : {23u * 48 + 23, 23u * 48 + 24, 24u * 48 + 23, 24u * 48 + 24})
        grid.holes[cell] = 1;
    return HeightField{*build_height_field(std::move(grid))};
}

// Eight steps down along x, then a slide that curves up again.
Geometry stairs_and_slide() {
    std::vector<Vec3> rim;  // the profile in the xy plane
    for (int k = 0; k <= 8; k++) {
        rim.push_back({k * 0.5, 3 - k * 0.3, 0});
        rim.push_back({k * 0.5 + 0.5, 3 - k * 0.3, 0});
    }
    for (int k = 1; k <= 16; k++) {
        const double x = 4.5 + k * 0.25, t = k / 16.0;
        rim.push_back({x, 0.6 - 1.4 * t + 1.6 * t * t, 0});
    }
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Vec3 p : rim)
        for (const double z : {-1.5, 1.5}) vertices.push_back({p.x, p.y, z});
    for (std::uint32_t k = 0; k + 1 < rim.size(); k++) {
        const std::uint32_t v = 2 * k;
        triangles.push_back({v, v + 1, v + 2});
        triangles.push_back({v + 1, v + 3, v + 2});
    }
    return Mesh{*build_mesh(vertices, triangles)};
}

}  // namespace

SceneDescription terrain() {
    SceneDescription scene{.bodies = {fixed_box("cellar", {0, -7, 0}, {200, 1, 200})}};
    SceneBody ground{
        .name = "hills", .body = {.type = BodyType::static_body}, .shapes = {}, .color = 0x5b7f4f};
    ground.shapes.push_back({.geometry = hills(), .material = {.friction = 0.8}});
    scene.bodies.push_back(ground);
    SceneBody slide{.name = "slide",
                    .body = {.type = BodyType::static_body, .pose = {{-11, 6, -9}, {}}},
                    .shapes = {},
                    .color = 0x9c8f7a};
    slide.shapes.push_back({.geometry = stairs_and_slide()});
    scene.bodies.push_back(slide);
    Random random(41);
    const std::uint32_t colors[] = {0xe76f51, 0xf4a261, 0x2a9d8f, 0x457b9d, 0xe9c46a};
    for (int i = 0; i < 60; i++) {
        const double x = random.in(-8, 8), z = random.in(-8, 8), turn = random.in(0, 3);
        const Geometry kinds[] = {Sphere{0.3}, Cylinder{0.35, 0.15}, stone(random, 0.4),
                                  Box{{0.3, 0.2, 0.25}}, Capsule{0.2, 0.25}};
        SceneBody body = colored(dynamic_body("stone", {x, height_at(x, z) + 2 + 0.1 * i, z},
                                              kinds[i % 5], from_axis_angle({1, 0.3, 0.2}, turn)),
                                 colors[i % 5]);
        body.shapes[0].material = {.friction = 0.7, .restitution = 0.1, .rolling_friction = 0.004};
        scene.bodies.push_back(body);
    }
    for (int i = 0; i < 5; i++)
        scene.bodies.push_back(colored(
            dynamic_body("ball", {-10.7, 10 + 1.2 * i, -9 + (i % 3 - 1) * 0.7}, Sphere{0.25}),
            0xe63946));
    return scene;
}

}  // namespace jostle::scenes
