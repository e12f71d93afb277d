// SPDX-License-Identifier: MIT
#include "bench/speed/speed_scenes.h"

#include <stdexcept>
#include <string>

#include "jostle/scenes/catalog.h"

namespace jostle::bench {
namespace {

constexpr SpeedScene table[] = {
    {.letter = "a", .name = "bench_pyramid_465"},
    {.letter = "b", .name = "bench_pyramid_5050"},
    {.letter = "c", .name = "bench_boxes_1000"},
    {.letter = "d", .name = "bench_pile_5000"},
    {.letter = "e", .name = "bench_player_901", .player = "player"},
    {.letter = "f", .name = "bench_ragdolls_40"},
    {.letter = "g", .name = "bench_joint_grid_10000"},
    {.letter = "h", .name = "bench_asleep_10000", .asleep_first = true},
    {.letter = "i", .name = "bench_bullets_1000", .steps = 120, .tunnelled_beyond_x = 0},
    {.letter = "trees", .name = "bench_trees", .all_move = true},
    {.letter = "convex_pile", .name = "bench_convex_pile", .all_move = true},
    {.letter = "washer", .name = "bench_washer", .all_move = true},
    {.letter = "hull_terrain", .name = "bench_hull_terrain", .all_move = true},
    {.letter = "chain", .name = "bench_chain", .all_move = true},
    {.letter = "rain", .name = "bench_rain", .all_move = true},
    {.letter = "vehicles", .name = "bench_vehicles", .all_move = true},
    {.letter = "rods", .name = "bench_rods", .all_move = true},
    {.letter = "box_shot",
     .name = "bench_box_shot",
     .all_move = true,
     .steps = 240,
     .tunnelled_beyond_x = 0.25},
    {.letter = "brick_wall", .name = "bench_brick_wall", .all_move = true, .sleeps = true},
    {.letter = "l_shapes", .name = "bench_l_shapes", .all_move = true},
    {.letter = "junkyard", .name = "bench_junkyard", .all_move = true},
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
