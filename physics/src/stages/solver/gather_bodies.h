// SPDX-License-Identifier: MIT
//
// Prepares and distributes the awake bodies of a step: solved bodies by the colour set of their
// island, kinematic bodies that the solver reads, and free bodies. Part of solve_constraints.
#pragma once

#include <cstdint>

#include "jostle/physics/mat3.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Writes the solver records of one body by its hot index, at the start of a step, for different
// bodies in parallel: SolverScratch::hot, external and spin_axes. `h`: length of a sub-step, s;
// unused for kinematic bodies.
void prepare_body(const StepContext& step, double h, std::uint32_t hot_index);

// Writes an inverse inertia, 1/(kg m^2).
void put_inertia(SolverBody& hot, const Mat3& inverse);

// Single-threaded. Reads: awake bodies, Island::colour_set, JointGroupScratch::grouped. Leaves in
// scratch: SolverScratch::bodies, jointed, kinematic, free and set_of.
void gather_bodies(StepContext& step);

// Writes the body and sub-step counters of the profile. Call after gather_bodies().
void count_solver_work(StepContext& step);

}  // namespace jostle::physics
