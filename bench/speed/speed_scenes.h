// SPDX-License-Identifier: MIT
//
// The measured scenes, by letter or word, with the settings that a scene does not contain: the
// number of steps, its parameters, the driven body, and the plane beyond which a body has
// tunnelled.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bench/speed/scene_parameters.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

struct SpeedScene {
    const char* letter;
    const char* name;
    bool all_move = false;  // one of the scenes in which all bodies move
    int steps = 600;
    bool sleeps = false;        // sleeping is enabled regardless of --sleep
    bool asleep_first = false;  // the same, and the measurement starts when all bodies sleep
    std::optional<std::string_view> player;    // name of the body that is driven in a circle
    std::optional<double> tunnelled_beyond_x;  // m: bodies beyond it at the end have tunnelled
    std::span<const ParameterRange> parameters = {};
    // Creates the scene with values for its parameters; null: the scene of the catalogue.
    scenes::SceneDescription (*make)(const ParameterValues& values) = nullptr;
    // Null: the scene is in the catalogue, which contains its description.
    const char* description = nullptr;
};

std::span<const SpeedScene> speed_scenes();

// By letter or name; null if there is no such scene.
const SpeedScene* find_speed_scene(std::string_view letter_or_name);

// Whether servers can host the scene by its name.
bool is_in_catalogue(const SpeedScene& speed_scene);
// That of the catalogue, or its own.
std::string description_of(const SpeedScene& speed_scene);

// Builds the scene. Parameters that are not chosen have their defaults; parameters that the scene
// does not have are ignored. Chosen values must be in their ranges.
scenes::SceneDescription build(const SpeedScene& speed_scene, const ParameterValues& chosen = {});

// Checks that each chosen parameter is one of a selected scene and in the range of each selected
// scene that has it. Returns an error that names the option, the accepted range and the scenes that
// have the parameter.
physics::Status check_parameters(std::span<const SpeedScene* const> selected,
                                 const ParameterValues& chosen);

// Index of the player body; nothing if the scene has none.
std::optional<std::uint32_t> player_of(const SpeedScene& speed_scene,
                                       const scenes::SceneDescription& scene);

// Velocity of the player this long after the start. Only x and z apply; the player keeps its
// vertical velocity.
physics::Vec3 player_velocity(double seconds);

}  // namespace jostle::bench
