// SPDX-License-Identifier: MIT
//
// Estimates the error of the sub-steps of a step relative to infinitely many: a step is solved
// twice from the same state, first with half of its sub-steps, and the difference is the estimate
// (step doubling: E. Hairer, S. Norsett, G. Wanner, "Solving ordinary differential equations I",
// II.4). Contacts have the same stiffness in both, or the estimate would be the difference of two
// springs. Contact compliance is a separate error: the overlap. Only in worlds with a tolerance.
//
// Reads: the hot records after the solver. Writes: Island::error. Restores contacts and joints to
// their state before the trial.
#pragma once

#include <cstddef>
#include <span>

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Returns whether this step runs a trial for the islands of a colour set.
bool wants_trial(const StepContext& step, std::size_t set);

// Before a trial: saves the contacts of the sets [first, last) and scales the impulses to sub-steps
// of twice the length. `jointed`: hot indices of bodies with joints.
void begin_trial(StepContext& step, std::size_t first, std::size_t last,
                 std::span<const std::uint32_t> jointed);
// After a trial: saves the motion of the bodies (by hot index) and restores everything else.
void end_trial(StepContext& step, std::size_t first, std::size_t last,
               std::span<const std::uint32_t> bodies, std::span<const std::uint32_t> jointed);
// After the step itself: stores the difference in the islands.
void compare_trial(StepContext& step, std::size_t first, std::size_t last,
                   std::span<const std::uint32_t> bodies);

// Lifetime of a velocity error: lasting for freely swinging bodies; damped if contacts and sweeps
// remove it.
enum class ErrorLife { lasting, damped };
// Error after one second of steps, m, if each step has a position error of `shift` m and a velocity
// error of `change` m/s.
double second_error(double shift, double change, double dt, ErrorLife life);
void note_error(Island& island, double error);

}  // namespace jostle::physics
