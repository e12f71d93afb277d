// SPDX-License-Identifier: MIT
//
// Access to a body during the solve, for effects that act in a sub-step without being constraints:
// force fields and listeners. Reads and writes the body's hot record. Thread-safe for different
// bodies.
#pragma once

#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// Current centre of mass, m, world.
Vec3 center_now(const BodyStore& bodies, const SolverScratch& scratch, std::uint32_t awake_index);
// Current pose and velocity in double, world axes.
BodyWarm motion_now(const BodyStore& bodies, const SolverScratch& scratch,
                    std::uint32_t awake_index);

// Inverse inertia as the solver uses it, 1/(kg m^2), world axes.
Mat3 solver_inverse_inertia(const SolverScratch& scratch, std::uint32_t awake_index);

// Applies an impulse in N s and an angular impulse in N m s about the centre of mass. It counts as
// a non-contact change, so no warm start repeats it.
void apply_solver_impulse(const BodyStore& bodies, SolverScratch& scratch,
                          std::uint32_t awake_index, Vec3 impulse, Vec3 angular_impulse);

}  // namespace jostle::physics
