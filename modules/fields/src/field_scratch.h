// SPDX-License-Identifier: MIT
//
// Memory that a Fields module reuses between steps. None of it is state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modules/fields/src/body_field_cache.h"
#include "modules/fields/src/water_forces.h"

namespace jostle::modules::fields_detail {

// Values shared by all bodies in a sub-step of a group, per field: the target of Central, if any,
// and the wave train of Waves.
struct SubstepFieldState {
    std::vector<std::optional<physics::Vec3>> targets;
    std::vector<WaveTrain> trains;
    WaterScratch water;
};

struct FieldScratch {
    BodyFieldCache body_cache;
    std::uint64_t step = 0;  // World::step_count() of the last use
};

}  // namespace jostle::modules::fields_detail
