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

}  // namespace jostle::physics
