// SPDX-License-Identifier: MIT
//
// Steps a rigid character: applies the impulses that give its body the desired velocity.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

void rigid_step(physics::World& world, CharacterData& record, double dt);

}  // namespace jostle::modules::character_detail
