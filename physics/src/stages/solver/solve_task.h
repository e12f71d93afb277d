// SPDX-License-Identifier: MIT
//
// A part of the solver's work that is independent of all other parts: its bodies share no contacts
// and joints with those of other tasks. Different tasks may be solved in parallel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// The colour sets [first, last) of one tier, with the same number of sub-steps.
struct SolverTask {
    SolverTier tier;
    std::size_t first, last;
    std::uint32_t weight;  // number of bodies and contacts
};

// Solves a task: SolverScratch::hot, contacts and joints then have their values at the end of the
// step. `kinematic`: hot indices of kinematic bodies that the task reads and moves with it.
void solve_task(StepContext& step, const SolverTask& task,
                std::span<const std::uint32_t> kinematic);

}  // namespace jostle::physics
