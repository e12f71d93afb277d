// SPDX-License-Identifier: MIT
//
// Asks listeners how two shapes shall touch (PreSolve of jostle/physics/step_listener.h), on the
// thread of the step.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

inline bool has_pre_solve_listeners(const ListenerStore& listeners) {
    return listeners.active_hooks.pre_solve;
}

// What is about to touch, by index of shape.
struct PreSolveContact {
    std::uint32_t shape_a, shape_b;
    Vec3 normal, point;  // unit, from a to b; m, world
    Vec3 velocity;       // m/s, of b against a there
};

// What all listeners make of an answer.
ContactModifier call_contact_listeners(const WorldState& world,
                                       const PreSolveContact& pre_solve_contact,
                                       ContactModifier modifier);

// For a contact whose manifold was just written: keeps what they say, if it is not what the
// materials give. Returns whether the manifold is to be written again.
bool modify_contact(WorldState& world, std::uint32_t contact);

}  // namespace jostle::physics
