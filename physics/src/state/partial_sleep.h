// SPDX-License-Identifier: MIT
//
// Partial sleep: a part of an island sleeps while the rest of it moves. A body that sleeps in place
// keeps its place in the awake set, but nobody solves it. For its neighbours that move it is as
// good as static, and contacts between bodies that sleep in place lie in a colour set of their own.
// What would move such a body wakes it (stages/sleep/wake_bodies.h). Bodies that joints tie
// together fall asleep and wake as one, so no joint has one that moves and one that sleeps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Puts dynamic bodies of the awake set to sleep in place, all of those that are jointed together
// and to no kinematic body, and keeps the forces at their contacts.
void sleep_in_place(WorldState& world, std::span<const std::uint32_t> bodies);
// A half of that, for a caller who moves the contacts himself: all bodies first, then save_load().
void hold_still(WorldState& world, std::uint32_t body);

// The body moves again, it alone. Its time at rest goes on.
void wake_in_place(WorldState& world, std::uint32_t body);
// With all that is jointed to it, and times at rest begin anew.
void wake_from_partial_sleep(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);
// ... and go on, but for the last steps before it would fall asleep: what still rests soon sleeps
// again, with what presses on it now.
void wake_briefly(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);
// Wakes the body, and briefly so much of what contacts lead to from it, kg: an impact is felt by
// more than the body that it hits, and what lost its support may have borne more than itself.
void wake_around(WorldState& world, std::uint32_t body, double mass, std::vector<BodyId>& woke);

}  // namespace jostle::physics
