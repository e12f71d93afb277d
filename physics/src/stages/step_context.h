// SPDX-License-Identifier: MIT
//
// What every stage of one step shares; made anew each step.
#pragma once

#include <array>

#include "physics/src/constraints/contact_settings.h"
#include "physics/src/foundation/timer.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// What a stage returns: `ran`, or why it had nothing to do, as a sentence that lives as long as the
// program.
using Skipped = const char*;
inline constexpr Skipped ran = nullptr;
inline constexpr Skipped no_awake_bodies = "nobody is awake";

struct StepScratch;

struct StepContext {
    WorldState& world;
    StepScratch& scratch;
    ThreadPool& thread_pool;
    double dt = 0;                                           // s
    std::array<ContactSettings, solved_set_count> contacts;  // by index_of(ColourSetKey)
    Timer timer = {};                                        // of the stages, for the profile
};

}  // namespace jostle::physics
