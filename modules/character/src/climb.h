// SPDX-License-Identifier: MIT
//
// Over a step: up, forward and down.
#pragma once

#include <optional>

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

// Where the centre comes to stand that starts at `from` and wants to go `way` (horizontal, m), when
// a step is in the way that can be climbed. `least`: m that it has to get further than that.
std::optional<physics::Vec3> climb(const EnvironmentQuery& near, const CharacterData& record,
                                   physics::Vec3 from, physics::Vec3 displacement,
                                   double min_progress);

// Where it stands when it is put down from `from` by at most `drop`: on floor that can be walked
// on, or on the edge of a step.
std::optional<physics::Vec3> step_down(const EnvironmentQuery& near, const CharacterData& record,
                                       physics::Vec3 from, double drop, double floor_height_max);

}  // namespace jostle::modules::character_detail
