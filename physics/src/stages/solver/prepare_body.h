// SPDX-License-Identifier: MIT
//
// Solver records of one body at the start of a step. Part of solve_constraints. May be called for
// different bodies in parallel.
#pragma once

#include <cstdint>

#include "jostle/physics/mat3.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Writes the records of a body by its hot index: SolverScratch::hot, external and spin_axes, and
// `gyroscopic` for a gyroscopic body. `h`: length of a sub-step, s; unused for kinematic bodies.
void prepare_body(const StepContext& step, double h, std::uint32_t hot_index);

// Writes an inverse inertia, 1/(kg m^2).
void put_inertia(SolverBody& hot, const Mat3& inverse);

}  // namespace jostle::physics
