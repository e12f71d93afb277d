// SPDX-License-Identifier: MIT
//
// A body in the middle of the solve, for what acts on it in a sub-step without being a constraint:
// force fields and listeners. Reads and writes the body's hot record; different bodies at once.
#pragma once

#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// m, of mass, world.
Vec3 center_now(const BodyStore& bodies, const SolverScratch& scratch, std::uint32_t awake_index);
// Where it is and how it moves now, in double, world axes.
BodyWarm motion_now(const BodyStore& bodies, const SolverScratch& scratch,
                    std::uint32_t awake_index);

// N s, and N m s about the centre of mass. It counts among what acts without contacts: no warm
// start repeats it.
void apply_solver_impulse(const BodyStore& bodies, SolverScratch& scratch,
                          std::uint32_t awake_index, Vec3 impulse, Vec3 angular_impulse);

}  // namespace jostle::physics
