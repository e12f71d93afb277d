// SPDX-License-Identifier: MIT
//
// The linear system of constraint rows and bodies (jostle/physics/constraint_system.h).
#pragma once

#include "jostle/physics/constraint_system.h"

namespace jostle::physics {

// The rate of the row at the current velocities; rate_by_forces(): at the velocities that forces
// alone give the bodies in a step.
double rate_now(const ConstraintRow& row, const std::vector<SystemBody>& bodies);
double rate_by_forces(const ConstraintRow& row, const std::vector<SystemBody>& bodies);
// The response of the row's rate to a unit impulse along it, without softness.
double response_of(const ConstraintRow& row, const std::vector<SystemBody>& bodies);

// Computes matrix and right-hand side from bodies and rows.
void assemble(ConstraintSystem& system);

}  // namespace jostle::physics
