// SPDX-License-Identifier: MIT
//
// Climbing a step: up, forward and down.
#pragma once

#include <optional>

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

// Returns the centre after climbing a step that blocks a horizontal displacement (m) from `from`;
// nullopt if there is no climbable step. The result advances by more than min_progress (m) along
// the displacement.
std::optional<physics::Vec3> climb(const EnvironmentQuery& near, const CharacterData& record,
                                   physics::Vec3 from, physics::Vec3 displacement,
                                   double min_progress);

// Lowers the character from `from` by at most `drop` (m). Returns the centre where it stands on
// walkable floor or on the edge of a step, at most floor_height_max (m, world y) high; otherwise
// nullopt.
std::optional<physics::Vec3> step_down(const EnvironmentQuery& near, const CharacterData& record,
                                       physics::Vec3 from, double drop, double floor_height_max);

}  // namespace jostle::modules::character_detail
