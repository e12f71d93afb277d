// SPDX-License-Identifier: MIT
//
// Range checks for character values from callers, scenes and saved state.
#pragma once

#include <initializer_list>

#include "jostle/modules/character.h"

namespace jostle::modules::character_detail {

physics::Status check_def(const CharacterDef& def);
physics::Status check_abilities(const CharacterAbilities& abilities);
physics::Status check_walk(physics::Vec3 walk);
physics::Status check_feet(physics::Vec3 feet);
physics::Status check_velocity(physics::Vec3 velocity);

// An ability and its range. Calls, scenes and saved state share this list.
struct Ability {
    const char* name;
    double CharacterAbilities::*value;
    double low, high;
};
inline constexpr Ability ability_ranges[] = {
    {"mass", &CharacterAbilities::mass, 1, 1e4},
    {"slope_limit", &CharacterAbilities::slope_limit, 0, 1.5},
    {"step_height", &CharacterAbilities::step_height, 0, 2},
    {"floor_snap", &CharacterAbilities::floor_snap, 0, 2},
    {"jump_speed", &CharacterAbilities::jump_speed, 0, 100},
    {"ground_acceleration", &CharacterAbilities::ground_acceleration, 0, 1e5},
    {"air_acceleration", &CharacterAbilities::air_acceleration, 0, 1e5},
    {"strength", &CharacterAbilities::strength, 0, 1e6},
};

inline constexpr double radius_min = 0.05, radius_max = 5;        // m
inline constexpr double height_max = 20;                          // m
inline constexpr double skin_min = 0.002;                         // m
inline constexpr double walk_speed_max = 1000, speed_max = 5000;  // m/s
inline constexpr double coordinate_max = 9e6;                     // m

}  // namespace jostle::modules::character_detail
