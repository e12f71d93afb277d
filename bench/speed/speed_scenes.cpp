// SPDX-License-Identifier: MIT
#include "bench/speed/speed_scenes.h"

#include <stdexcept>
#include <string>

#include "jostle/scenes/catalog.h"

namespace jostle::bench {
namespace {

constexpr SpeedScene table[] = {
    {.letter = "a", .name = "lab_pyramid_465"},
    {.letter = "b", .name = "lab_pyramid_5050"},
    {.letter = "c", .name = "lab_boxes_1000"},
    {.letter = "d", .name = "lab_pile_5000"},
    {.letter = "e", .name = "lab_player_901", .player = "player"},
    {.letter = "f", .name = "lab_ragdolls_40"},
    {.letter = "g", .name = "lab_joint_grid_10000"},
    {.letter = "h", .name = "lab_asleep_10000", .asleep_first = true},
    {.letter = "i", .name = "lab_bullets_1000", .steps = 120, .tunnelled_beyond_x = 0},
    {.letter = "trees", .name = "lab_trees", .all_move = true},
    {.letter = "convex_pile", .name = "lab_convex_pile", .all_move = true},
    {.letter = "washer", .name = "lab_washer", .all_move = true},
    {.letter = "hull_terrain", .name = "lab_hull_terrain", .all_move = true},
    {.letter = "chain", .name = "lab_chain", .all_move = true},
    {.letter = "rain", .name = "lab_rain", .all_move = true},
    {.letter = "vehicles", .name = "lab_vehicles", .all_move = true},
    {.letter = "rods", .name = "lab_rods", .all_move = true},
    {.letter = "box_shot",
     .name = "lab_box_shot",
     .all_move = true,
     .steps = 240,
     .tunnelled_beyond_x = 0.25},
    {.letter = "brick_wall", .name = "lab_brick_wall", .all_move = true, .sleeps = true},
    {.letter = "l_shapes", .name = "lab_l_shapes", .all_move = true},
    {.letter = "junkyard", .name = "lab_junkyard", .all_move = true},
};

}  // namespace

std::span<const SpeedScene> speed_scenes() {
    return table;
}

const SpeedScene* find_speed_scene(std::string_view letter_or_name) {
    for (const SpeedScene& scene : table)
        if (letter_or_name == scene.letter || letter_or_name == scene.name) return &scene;
    return nullptr;
}

scenes::SceneDescription build(const SpeedScene& speed_scene) {
    auto scene = scenes::find_scene(speed_scene.name);
    if (!scene)
        throw std::logic_error(std::string("the catalogue has no scene ") + speed_scene.name);
    return std::move(*scene);
}

std::optional<std::uint32_t> player_of(const SpeedScene& speed_scene,
                                       const scenes::SceneDescription& scene) {
    if (!speed_scene.player) return std::nullopt;
    for (std::uint32_t body = 0; body < scene.bodies.size(); body++)
        if (scene.bodies[body].name == *speed_scene.player) return body;
    throw std::logic_error(scene.name + " has no body " + std::string(*speed_scene.player));
}

physics::Vec3 player_velocity(double seconds) {
    const physics::SinCos turned = physics::sin_cos(seconds < 2.5 ? 0 : (seconds - 2.5) * 0.8);
    return physics::Vec3{turned.cos, 0, turned.sin} * 6;
}

}  // namespace jostle::bench
