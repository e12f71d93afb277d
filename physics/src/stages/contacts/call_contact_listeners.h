// SPDX-License-Identifier: MIT
//
// Calls listeners to modify how two shapes touch (PreSolve in jostle/physics/step_listener.h), on
// the thread of the step.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

inline bool has_pre_solve_listeners(const ListenerStore& listeners) {
    return listeners.active_hooks.pre_solve;
}

// The contact that is about to touch, by shape indices.
struct PreSolveContact {
    std::uint32_t shape_a, shape_b;
    Vec3 normal, point;  // unit, from a to b; m, world
    Vec3 velocity;       // m/s, of b relative to a at the point
};

// Applies all listeners to a modifier and returns the result.
ContactModifier call_contact_listeners(const ListenerStore& listeners, const ShapedBodies& stores,
                                       const PreSolveContact& pre_solve_contact,
                                       ContactModifier modifier);

// Call after the manifold of a contact was written. Stores the listeners' modifier if it differs
// from the materials' values. Returns whether the manifold must be written again.
bool modify_contact(WorldState& world, std::uint32_t contact);

}  // namespace jostle::physics
