// SPDX-License-Identifier: MIT
//
// Checks the consistency of all stores. Used for loaded worlds, whose bytes may come from untrusted
// sources, and by tests after changes.
#pragma once

#include <optional>
#include <string>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the first inconsistency, or nullopt. Reads only loaded data, so it can run before
// serialization/derive.h.
std::optional<std::string> find_fault(const WorldStores& world);

// Checks that each number of a world is one that calls of World and steps can produce. Others, such
// as a mass without a shape or a negative time at rest, come from forged bytes. Called by
// find_fault before the stores are compared. Returns the first number out of range, or nullopt.
std::optional<std::string> find_number_fault(const WorldStores& world);

}  // namespace jostle::physics
