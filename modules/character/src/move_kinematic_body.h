// SPDX-License-Identifier: MIT
//
// How the body of a sweeping character follows it.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// To where the record's feet are, within the step and no faster than `speed` (m/s). What goes
// beyond that, over a step (`rise`, m) or out of what it overlaps, is a leap: it kicks nobody by
// it.
void move_kinematic_body(physics::World& world, const CharacterData& record, double rise,
                         double speed, double dt);

}  // namespace jostle::modules::character_detail
