// SPDX-License-Identifier: MIT
//
// Memory that a step uses and the next one uses again, stage by stage. Neither description nor
// state: never saved, never hashed. A stage's header says what it leaves here for a later one.
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
    // Set by any thread: what remains of the step does without sub-steps and sweeps.
    std::atomic<bool> stopped{false};
    PairScratch pairs;
    ContactScratch contacts;
    IslandScratch islands;
    SolverScratch solver;
    FinalizeScratch finalize;
    ContinuousScratch continuous;
    SleepScratch sleep;
};

// Whoever drives a stage asks between its rounds; the threads that help it are told by it.
inline bool is_stopped(const StepContext& step) {
    return step.scratch.stopped.load(std::memory_order_relaxed);
}

}  // namespace jostle::physics
