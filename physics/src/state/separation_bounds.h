// SPDX-License-Identifier: MIT
//
// Separation bounds (ContactStore::bounds): when a separated pair must be tested again.
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Sets the bound by the relative motion of the two centres, which are `apart`: along a direction,
// or by length if it is zero. `a`, `b`: motion bounds of the two bodies.
void set_separation_bound(SeparationBound& bound, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b);

// The pair need not be tested until its bodies may have approached each other by `slack`, m. A
// dormant contact retains its position and limit.
void add_separation_bound(const BodySets& sets, ContactStore& contacts, std::uint32_t contact,
                          double slack, Vec3 direction = {});
// Restores the bound of a dormant contact.
void resume_separation_bound(ContactStore& contacts, std::uint32_t contact);

// Returns whether a pair may touch in the next step of `dt`. If not, updates the limit of the next
// test. Writes only the bound, so it is thread-safe for different bounds.
bool is_due(const BodySets& sets, const WorldDef& def, SeparationBound& bound, double dt);

// Measures the separation of a due pair along the direction of its bound, if it has one. Returns
// whether it suffices for the next step, which sets the bound anew: the narrow phase need not test
// the pair. Writes only the bound.
bool renew_separation_bound(const ContactGraph& stores, SeparationBound& bound, double dt);

// Returns whether a pair remained within its bound throughout a step in which both bodies moved
// linearly, so that it did not touch. `before`, `now`: vectors from a's centre of mass to b's.
bool stayed_apart(const BodyStore& bodies, const SeparationBound& bound, Vec3 previous, Vec3 now);

}  // namespace jostle::physics
