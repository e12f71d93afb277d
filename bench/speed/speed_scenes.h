// SPDX-License-Identifier: MIT
//
// The catalogue's scenes that are measured, by letter or word, and what is done with each that a
// scene does not say: how long it runs, who is driven, what counts as gone through a wall.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "jostle/scenes/scene.h"

namespace jostle::bench {

struct SpeedScene {
    const char* letter;
    const char* name;       // in the catalogue
    bool all_move = false;  // one of the twelve in which everything moves
    int steps = 600;
    bool sleeps = false;                       // sleep is on, whatever is asked for
    bool asleep_first = false;                 // as well, and the clock starts when all sleep
    std::optional<std::string_view> player;    // the body of this name is driven in a circle
    std::optional<double> tunnelled_beyond_x;  // m: who ends there went through the wall
};

std::span<const SpeedScene> speed_scenes();

// By letter or name; null when there is no such scene.
const SpeedScene* find_speed_scene(std::string_view letter_or_name);

// From the catalogue.
scenes::SceneDescription build(const SpeedScene& speed_scene);

// Which of the scene's bodies is the player; nothing when none is.
std::optional<std::uint32_t> player_of(const SpeedScene& speed_scene,
                                       const scenes::SceneDescription& scene);

// Where the player is driven this long after the start: only x and z count, the fall stays its own.
physics::Vec3 player_velocity(double seconds);

}  // namespace jostle::bench
