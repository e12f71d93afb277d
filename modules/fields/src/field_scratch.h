// SPDX-License-Identifier: MIT
//
// What the steps of a Fields module use again: nothing in it is state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modules/fields/src/body_field_cache.h"
#include "modules/fields/src/water_forces.h"

namespace jostle::modules::fields_detail {

// What all bodies of a group's sub-step have in common, for each field: where Central pulls to, if
// anywhere; the moment of Waves.
struct SubstepFieldState {
    std::vector<std::optional<physics::Vec3>> targets;
    std::vector<WaveTrain> trains;
    WaterScratch water;
};

struct FieldScratch {
    BodyFieldCache body_cache;
    std::uint64_t step = 0;  // World::step_count() when they were last used
};

}  // namespace jostle::modules::fields_detail
