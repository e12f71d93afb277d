// SPDX-License-Identifier: MIT
//
// Whether each number of a world is one that the calls of World and the steps make: a mass that no
// shape has, or a rest that lasts less than no time, comes from forged bytes alone. Called by
// validate.h, before the stores are compared.
#pragma once

#include <optional>
#include <string>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The first number that is out of its range, or nothing.
std::optional<std::string> find_number_fault(const WorldState& world);

}  // namespace jostle::physics
