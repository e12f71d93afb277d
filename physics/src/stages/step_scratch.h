// SPDX-License-Identifier: MIT
//
// Memory that a step uses and the next one uses again, stage by stage. Neither description nor
// state: never saved, never hashed. A stage's header says what it leaves here for a later one.
#pragma once

#include "stages/contacts/contact_scratch.h"
#include "stages/continuous/continuous_scratch.h"
#include "stages/finalize/finalize_scratch.h"
#include "stages/islands/island_scratch.h"
#include "stages/pairs/pair_scratch.h"
#include "stages/sleep/sleep_scratch.h"
#include "stages/solver/solver_scratch.h"

namespace jostle::physics {

struct StepScratch {
    PairScratch pairs;
    ContactScratch contacts;
    IslandScratch islands;
    SolverScratch solver;
    FinalizeScratch finalize;
    ContinuousScratch continuous;
    SleepScratch sleep;
};

}  // namespace jostle::physics
