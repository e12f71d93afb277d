// SPDX-License-Identifier: MIT
//
// Checks that every store agrees with every other. Used on loaded worlds, whose bytes may come from
// anywhere, and by tests after each kind of change.
#pragma once

#include <optional>
#include <string>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The first thing that is wrong, or nothing. Reads only what a load restores, so it may run before
// persist/derive.h.
std::optional<std::string> find_fault(const WorldState& world);

}  // namespace jostle::physics
