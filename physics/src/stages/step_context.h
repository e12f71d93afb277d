// SPDX-License-Identifier: MIT
//
// What every stage of one step shares; made anew each step.
#pragma once

#include <array>

#include "constraints/contact_settings.h"
#include "foundation/timer.h"
#include "state/world_state.h"

namespace jostle::physics {

// What a stage returns: why it had nothing to do, as a sentence that lives for ever, or `ran`.
using Skipped = const char*;
inline constexpr Skipped ran = nullptr;
inline constexpr Skipped nobody_awake = "nobody is awake";

struct StepScratch;

struct StepContext {
    WorldState& world;
    StepScratch& scratch;
    TaskTeam& team;
    double dt = 0;  // s
    std::array<ContactSettings, tier_count> contacts;
    Timer timer = {};
};

}  // namespace jostle::physics
