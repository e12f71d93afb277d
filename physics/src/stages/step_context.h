// SPDX-License-Identifier: MIT
//
// Data shared by all stages of one step. Rebuilt in each step.
#pragma once

#include <array>

#include "physics/src/constraints/contact_settings.h"
#include "physics/src/foundation/timer.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Result of a stage: `ran`, or the reason why it had nothing to do, as a string with static
// lifetime.
using Skipped = const char*;
inline constexpr Skipped ran = nullptr;
inline constexpr Skipped no_awake_bodies = "no awake bodies";

struct StepScratch;

struct StepContext {
    WorldState& world;
    StepScratch& scratch;
    ThreadPool& thread_pool;
    double dt = 0;                                           // s
    std::array<ContactSettings, solved_set_count> contacts;  // indexed by index_of(ColourSetKey)
    Timer timer = {};                                        // per stage, for the profile
    int stages_run = 0;  // stages whose first part ran or was skipped
};

}  // namespace jostle::physics
