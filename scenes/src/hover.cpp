// SPDX-License-Identifier: MIT
//
// A craft flown by the module of the hovercraft example.
#include "jostle/physics/height_field.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// 80 m square: waves 20 m long and 0.8 m high, and a rim that contains loose bodies.
double wave_height(double x, double z) {
    const double r = square_root(x * x + z * z);
    const double rim = r > 22 ? 0.15 * (r - 22) * (r - 22) : 0;
    return 0.4 * sin_cos(0.314 * x + 0.1 * z).sin + rim;
}

Geometry waves() {
    constexpr std::uint32_t samples = 81;
    HeightGrid grid{.columns = samples, .rows = samples};
    for (std::uint32_t r = 0; r < samples; r++)
        for (std::uint32_t c = 0; c < samples; c++)
            grid.heights.push_back(wave_height(c - 40.0, r - 40.0));
    return HeightField{*build_height_field(std::move(grid))};
}

}  // namespace

SceneDescription hovercraft() {
    SceneDescription scene;
    SceneBody sea{
        .name = "waves", .body = {.type = BodyType::static_body}, .shapes = {}, .color = 0x3d5a80};
    sea.shapes.push_back({.geometry = waves(), .material = {.friction = 0.4}});
    scene.bodies.push_back(sea);
    SceneBody craft = colored(dynamic_body("craft", {11, 2, 0}, Box{{1, 0.3, 1.6}}), 0xee6c4d);
    craft.shapes[0].density = 150;
    SceneBody& added = scene.bodies.emplace_back(std::move(craft));
    added.shapes.push_back(
        {.geometry = Box{{0.5, 0.25, 0.5}}, .pose = {{0, 0.55, 0.3}, {}}, .density = 30});
    Random random(7);
    for (int i = 0; i < 24; i++) {
        const double turn = 6.2832 * i / 24, r = random.in(7, 17);
        const SinCos at = sin_cos(turn);
        const double x = r * at.cos, z = r * at.sin;
        const Geometry kinds[] = {Sphere{0.35}, Cylinder{0.3, 0.3}, Box{{0.3, 0.25, 0.35}}};
        SceneBody buoy =
            colored(dynamic_body("buoy", {x, wave_height(x, z) + 0.6, z}, kinds[i % 3]),
                    i % 2 == 0 ? 0xe9c46a : 0xf4f1de);
        buoy.shapes[0].density = 60;
        buoy.shapes[0].material = {.friction = 0.5, .restitution = 0.3, .rolling_friction = 0.01};
        scene.bodies.push_back(buoy);
    }
    scene.modules.push_back({.tag = "hovercraft",
                             .settings = {{"radius", 11}, {"speed", 7}},
                             .bodies = {{"craft", 1}},
                             .state = {}});
    return scene;
}

}  // namespace jostle::scenes
