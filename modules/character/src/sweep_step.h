// SPDX-License-Identifier: MIT
//
// One step of a sweeping character.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

void sweep_step(physics::World& world, CharacterData& record, double dt);

}  // namespace jostle::modules::character_detail
