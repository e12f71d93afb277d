// SPDX-License-Identifier: MIT
//
// How far the sub-steps of a step lead from where endlessly many would: a step is solved twice from
// the same state, with half of its sub-steps first, and the difference tells (step doubling: E.
// Hairer, S. Norsett, G. Wanner, "Solving ordinary differential equations I", II.4). Contacts are
// as stiff in both, or the difference would be that of two springs. How far they yield is an error
// of its own: what they overlap. Only in worlds with a tolerance.
//
// Reads: what the solver left in the hot records. Writes: Island::error. Leaves contacts and joints
// as they were before the trial.
#pragma once

#include <cstddef>
#include <span>

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Whether this step of the islands of a colour set is to be taken twice.
bool wants_trial(const StepContext& step, std::size_t set);

// Before a trial: keeps the contacts of the sets [first, last), and makes impulses those of
// sub-steps twice as long. `jointed`: hot indices of bodies with joints.
void begin_trial(StepContext& step, std::size_t first, std::size_t last,
                 std::span<const std::uint32_t> jointed);
// After it: keeps what the bodies, by hot index, did, and puts the rest back.
void end_trial(StepContext& step, std::size_t first, std::size_t last,
               std::span<const std::uint32_t> bodies, std::span<const std::uint32_t> jointed);
// After the step itself: the difference, into the islands.
void compare_trial(StepContext& step, std::size_t first, std::size_t last,
                   std::span<const std::uint32_t> bodies);

// How long an error of a velocity goes on: for good in what swings freely; contacts and sweeps take
// it back.
enum class ErrorLife { lasting, damped };
// m: by how much a second of steps is off, each of which is off by so much: `shift` of a place in
// m, `change` of a velocity in m/s.
double second_error(double shift, double change, double dt, ErrorLife life);
void note_error(Island& island, double error);

}  // namespace jostle::physics
