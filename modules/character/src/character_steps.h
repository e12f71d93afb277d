// SPDX-License-Identifier: MIT
//
// The step of a character, by its kind.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// Steps a rigid character: applies the impulses that give its body the desired velocity.
void rigid_step(physics::World& world, CharacterData& record, double dt);

// One step of a sweeping character.
void sweep_step(physics::World& world, CharacterData& record, double dt);

}  // namespace jostle::modules::character_detail
