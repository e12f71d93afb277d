// SPDX-License-Identifier: MIT
//
// Euler's equations for gyroscopic bodies in one sub-step: those whose SolverScratch::spin_axes are
// not `world`. Part of solve_constraints. Different bodies may be integrated in parallel.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Applies half of the spin change of a sub-step to bodies with joints, before their points are
// solved for the last time. The points then constrain the mean spin of the sub-step. `jointed`: hot
// indices; `h`: length of the sub-step, s.
void begin_gyroscopic(StepContext& step, std::span<const std::uint32_t> jointed, double h);

// Applies the rest of the spin change, for bodies without joints all of it. Call before the kernel
// that adds h w to the rotation vectors.
void integrate_gyroscopic(StepContext& step, std::span<const std::uint32_t> bodies, double h);

}  // namespace jostle::physics
