// SPDX-License-Identifier: MIT
//
// Ropes that may touch each other in a step.
#pragma once

#include <memory>
#include <span>

#include "modules/rope/src/rope_data.h"

namespace jostle::modules::rope_detail {

// After begin_step() of all ropes: gives each awake rope that is near others, and has
// RopeDef::collide_ropes, a leader, companions and obstacles. Wakes ropes near which another one
// moves.
void find_companions(std::span<const std::unique_ptr<Rope>> ropes, double dt,
                     physics::Vec3 gravity);
// Before a rope is removed or its links change: no other one refers to it or to its links.
void forget_companion(std::span<const std::unique_ptr<Rope>> ropes, const Rope& removed);

}  // namespace jostle::modules::rope_detail
