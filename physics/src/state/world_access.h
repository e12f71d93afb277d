// SPDX-License-Identifier: MIT
//
// Access to the stores of a World, for the library's own files and tests.
#pragma once

#include "jostle/physics/world.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

struct WorldAccess {
    static WorldState& state(World& world) { return *world.state_; }
    static const WorldState& state(const World& world) { return *world.state_; }
};

inline WorldState& state_of(World& world) {
    return WorldAccess::state(world);
}
inline const WorldState& state_of(const World& world) {
    return WorldAccess::state(world);
}

}  // namespace jostle::physics
