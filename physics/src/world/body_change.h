// SPDX-License-Identifier: MIT
//
// What every change of a body from outside has in common.
#pragma once

#include "jostle/physics/result.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// What the next step will probably take, s.
inline double expected_dt(const WorldState& world) {
    return world.last_dt > 0 ? world.last_dt : 1.0 / 60;
}

// The body is awake; its velocity or what acts on it is about to change.
BodyWarm& wake_to_change(WorldState& world, std::uint32_t body);

// After its pose or shapes changed: new fat boxes.
void after_move(WorldState& world, std::uint32_t body);
// After its velocity changed: what it will meet in the next step must be among its pairs.
void after_push(WorldState& world, std::uint32_t body);

// Velocities along and about locked axes are none. Kinematic bodies know no locks.
void obey_locks(const BodyCold& cold, BodyWarm& warm);

// That it exists and is dynamic.
Status check_dynamic(const WorldState& world, BodyId id);

}  // namespace jostle::physics
