// SPDX-License-Identifier: MIT
//
// The whole step. step_world.cpp reads from top to bottom, one call per stage. stages.h
// documents what each reads, what it writes, and what it leaves in scratch for which later stage.
#pragma once

#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// dt: s, above 0. Runs on the thread that calls World::step(); stages share work with the world's
// thread pool.
void step_world(WorldState& world, StepScratch& scratch, double dt);

}  // namespace jostle::physics
