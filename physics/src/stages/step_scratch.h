// SPDX-License-Identifier: MIT
//
// Memory that steps reuse, stage by stage. Neither description nor state: never saved, never
// hashed. The header of each stage documents what it leaves here for later stages.
#pragma once

#include <atomic>

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/continuous/continuous_scratch.h"
#include "physics/src/stages/finalize/finalize_scratch.h"
#include "physics/src/stages/islands/island_scratch.h"
#include "physics/src/stages/pairs/pair_scratch.h"
#include "physics/src/stages/sleep/sleep_scratch.h"
#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

struct StepScratch {
    // May be set by any thread. The rest of the step then skips sub-steps and sweeps.
    std::atomic<bool> stopped{false};
    PairScratch pairs;
    ContactScratch contacts;
    IslandScratch islands;
    SolverScratch solver;
    FinalizeScratch finalize;
    ContinuousScratch continuous;
    SleepScratch sleep;
};

// The thread that runs a stage polls this between rounds and informs its helper threads.
inline bool is_stopped(const StepContext& step) {
    return step.scratch.stopped.load(std::memory_order_relaxed);
}

}  // namespace jostle::physics
