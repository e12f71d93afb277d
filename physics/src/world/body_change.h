// SPDX-License-Identifier: MIT
//
// Common steps of all calls that change a body.
#pragma once

#include "jostle/physics/result.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The expected duration of the next step, s.
inline double expected_dt(const SteppingState& stepping) {
    return stepping.last_dt > 0 ? stepping.last_dt : 1.0 / 60;
}

// Wakes a body whose velocity, forces or properties are about to change.
BodyWarm& wake_to_change(WorldState& world, std::uint32_t body);

// Call after a change of pose or shapes: updates the fat bounding boxes.
void after_move(WorldState& world, std::uint32_t body);
// Call after a change of velocity: the pairs must include everything that the body can reach in the
// next step.
void after_push(WorldState& world, std::uint32_t body);

// Clears velocities along and about locked axes. Locks do not apply to kinematic bodies.
void obey_locks(const BodyCold& cold, BodyWarm& warm);

// Checks that the body exists and is dynamic.
Status check_dynamic(const BodyStore& bodies, BodyId id);

}  // namespace jostle::physics
