// SPDX-License-Identifier: MIT
//
// Cloths that may touch each other in a step.
#pragma once

#include <memory>
#include <span>

#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules::cloth_detail {

// After begin_step() of all cloths: gives each awake cloth that is near others, and has
// ClothDef::collide_cloths, a leader, companions and obstacles. Wakes cloths near which another one
// moves.
void find_companions(std::span<const std::unique_ptr<Cloth>> cloths, double dt,
                     physics::Vec3 gravity);
// Before a cloth is removed: no other one refers to it.
void forget_companion(std::span<const std::unique_ptr<Cloth>> cloths, const Cloth& removed);

}  // namespace jostle::modules::cloth_detail
