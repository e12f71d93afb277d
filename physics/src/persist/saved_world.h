// SPDX-License-Identifier: MIT
//
// The bytes of a saved world, for all who have its stores: a world, or a moment that was kept.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "persist/byte_visitors.h"
#include "state/world_state.h"

namespace jostle::physics {

// write_modules comes after all else and writes what visit_modules() does. Changes nothing: the
// field list is shared with loading, so it takes references.
std::vector<std::byte> saved_world(const WorldStores& stores,
                                   const std::function<void(Saver&)>& write_modules);

}  // namespace jostle::physics
