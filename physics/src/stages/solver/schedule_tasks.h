// SPDX-License-Identifier: MIT
//
// Divides the solver's work into tasks and distributes them over the threads. Part of
// solve_constraints.
#pragma once

#include <vector>

#include "physics/src/stages/solver/solve_task.h"

namespace jostle::physics {

// Divides the bodies of SolverScratch::bodies into tasks, ordered by their colour sets. With
// several threads each batch of a tier is a task. One thread fills the lanes of blocks best with
// all batches of a tier at once. Results do not depend on the division, because islands are
// independent.
std::vector<SolverTask> make_tasks(const StepContext& step);

// Solves all tasks. A light task, by itself or compared with the others, is solved by one thread
// without waiting for other threads. All threads share the colours of a heavier task.
void run_tasks(StepContext& step, const std::vector<SolverTask>& tasks);

}  // namespace jostle::physics
