// SPDX-License-Identifier: MIT
//
// Moves the body of a sweeping character to the character.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// Moves the body to the feet of the character within the step, no faster than `speed` (m/s). The
// rest of the displacement, from climbing a step (`rise`, m) or from leaving an overlap, is a
// teleport, so it does not strike other bodies.
void move_kinematic_body(physics::World& world, const CharacterData& record, double rise,
                         double speed, double dt);

}  // namespace jostle::modules::character_detail
