// SPDX-License-Identifier: MIT
//
// Euler's equations for gyroscopic bodies in one sub-step: those whose SolverScratch::spin_axes are
// not `world`. Part of solve_constraints.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Lists the gyroscopic ones among `bodies` (hot indices). Call after prepare_body().
void find_gyroscopic(StepContext& step, std::span<const std::uint32_t> bodies,
                     GyroscopicBodies& found);

// Applies half of the spin change of a sub-step to bodies with joints, before their points are
// solved for the last time. The points then constrain the mean spin of the sub-step. `h`: length of
// the sub-step, s.
void begin_gyroscopic(StepContext& step, GyroscopicBodies& bodies, double h);

// Applies the rest of the spin change, for bodies without joints all of it. Call before the kernel
// that adds h w to the rotation vectors.
void end_gyroscopic(StepContext& step, GyroscopicBodies& bodies, double h);

}  // namespace jostle::physics
