// SPDX-License-Identifier: MIT
//
// One step of a rigid character: impulses that give its body the velocity that is wanted.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

void rigid_step(physics::World& world, CharacterData& record, double dt);

}  // namespace jostle::modules::character_detail
