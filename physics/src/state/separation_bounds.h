// SPDX-License-Identifier: MIT
//
// When a pair that is apart must be looked at again: ContactStore::bounds.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// From now on by the motion of the two centres, which are `apart`, against each other: along a
// direction, or by its length if that is zero. `a`, `b`: of the two bodies.
void set_separation_bound(SeparationBound& bound, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b);

// The pair need not be looked at before its bodies may have come nearer to each other by `slack`,
// m. A dormant contact keeps its place and limit.
void add_separation_bound(WorldState& world, std::uint32_t contact, double slack,
                          Vec3 direction = {});
// A dormant contact has its bound again, as before.
void resume_separation_bound(WorldState& world, std::uint32_t contact);

// Whether a pair may touch in the next step of `dt`; if not, knows from when on to ask again.
// Writes the bound alone: for many threads.
bool is_due(const WorldState& world, SeparationBound& bound, double dt);

// Whether a pair has not used up its bound, at no moment of a step in which both bodies moved
// evenly: so it did not touch in that step. `before`, `now`: from a's centre of mass to b's.
bool stayed_apart(const WorldState& world, const SeparationBound& bound, Vec3 before, Vec3 now);

}  // namespace jostle::physics
