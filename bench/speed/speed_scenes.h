// SPDX-License-Identifier: MIT
//
// The measured scenes of the catalogue, by letter or word, with the settings that a scene does not
// contain: the number of steps, the driven body, and the plane beyond which a body has tunnelled.
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
    bool all_move = false;  // one of the twelve scenes in which all bodies move
    int steps = 600;
    bool sleeps = false;        // sleeping is enabled regardless of --sleep
    bool asleep_first = false;  // the same, and the measurement starts when all bodies sleep
    std::optional<std::string_view> player;    // name of the body that is driven in a circle
    std::optional<double> tunnelled_beyond_x;  // m: bodies beyond it at the end have tunnelled
};

std::span<const SpeedScene> speed_scenes();

// By letter or name; null if there is no such scene.
const SpeedScene* find_speed_scene(std::string_view letter_or_name);

// Builds the scene from the catalogue.
scenes::SceneDescription build(const SpeedScene& speed_scene);

// Index of the player body; nothing if the scene has none.
std::optional<std::uint32_t> player_of(const SpeedScene& speed_scene,
                                       const scenes::SceneDescription& scene);

// Velocity of the player this long after the start. Only x and z apply; the player keeps its
// vertical velocity.
physics::Vec3 player_velocity(double seconds);

}  // namespace jostle::bench
