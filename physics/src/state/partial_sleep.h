// SPDX-License-Identifier: MIT
//
// Partial sleep: a part of an island sleeps while the rest of it moves. A body that sleeps in place
// remains in the awake set but is not solved. It acts like a static body on its moving neighbours,
// and contacts between bodies that sleep in place are in a separate colour set. A disturbance wakes
// the body (stages/sleep/wake_bodies.cpp). Bodies connected by joints fall asleep and wake
// together, so no joint connects a moving and a sleeping body.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Puts dynamic bodies of the awake set to sleep in place and stores the forces at their contacts.
// `bodies` contains complete groups of jointed bodies, none of which is connected to a kinematic
// body.
void sleep_in_place(ContactGraph& stores, std::span<const std::uint32_t> bodies);
// First half of sleep_in_place(), for callers that move the contacts themselves: first all bodies,
// then save_load().
void hold_still(BodyStore& bodies, std::uint32_t body);

// Wakes this body only. Its time at rest continues.
void wake_in_place(ContactGraph& stores, std::uint32_t body);
// Wakes the body with all bodies connected by joints, and resets their time at rest.
void wake_from_partial_sleep(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);
// Same, but retains the time at rest up to a few steps before falling asleep: bodies that still
// rest soon sleep again, with the current forces.
void wake_briefly(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);
// Wakes the body, and briefly its surroundings along contacts up to this mass in kg: an impact
// affects more than the body that it hits, and a body that lost its support may have carried more
// than itself.
void wake_around(WorldState& world, std::uint32_t body, double mass, std::vector<BodyId>& woke);

}  // namespace jostle::physics
