// SPDX-License-Identifier: MIT
//
// The islands of SolverTier::direct, whose contacts are solved together
// (constraints/contact_group).
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// One group per set of bodies that manifolds connect, whether they touch yet or not. `bodies`: hot
// indices of all dynamic bodies of a task, after they are prepared.
void find_contact_groups(StepContext& step, std::span<const std::uint32_t> bodies,
                         ContactGroups& groups);

}  // namespace jostle::physics
