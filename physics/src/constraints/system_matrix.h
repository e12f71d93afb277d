// SPDX-License-Identifier: MIT
//
// The linear system of rows and bodies (jostle/physics/constraint_system.h).
#pragma once

#include "jostle/physics/constraint_system.h"

namespace jostle::physics {

// The row's rate when bodies have these velocities.
double rate_now(const ConstraintRow& row, const std::vector<SystemBody>& bodies);
double rate_by_forces(const ConstraintRow& row, const std::vector<SystemBody>& bodies);
// What a unit impulse along the row does to its rate, without softness.
double response_of(const ConstraintRow& row, const std::vector<SystemBody>& bodies);

// Fills in matrix and right from bodies and rows.
void assemble(ConstraintSystem& system);

}  // namespace jostle::physics
