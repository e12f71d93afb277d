// SPDX-License-Identifier: MIT
//
// Checks that each number of a world is one that calls of World and steps can produce. Others, such
// as a mass without a shape or a negative time at rest, come from forged bytes. Called by
// validate.h before the stores are compared.
#pragma once

#include <optional>
#include <string>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the first number out of range, or nullopt.
std::optional<std::string> find_number_fault(const WorldStores& world);

}  // namespace jostle::physics
