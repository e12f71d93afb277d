// SPDX-License-Identifier: MIT
//
// Which joints a body has, and what hangs together by them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The joint's record is filled: puts it on its bodies' lists and joins their islands (both awake).
void attach_joint(WorldState& world, std::uint32_t joint);
// The shapes of its bodies may meet from then on.
void destroy_joint(WorldState& world, std::uint32_t joint);
// The islands of a joint that has changed may be solved directly again (Island::too_dense_for).
void reset_density(WorldState& world, std::uint32_t joint);
// Whether a joint forbids the two bodies to collide.
bool joined_without_contact(const WorldState& world, std::uint32_t a, std::uint32_t b);

// The body and all that joints tie to it, in order; `to_kinematic`: one of them is tied to a
// kinematic body, which they follow. Until the next call.
struct JointedBodies {
    std::span<const std::uint32_t> bodies;
    bool to_kinematic = false;
};
JointedBodies jointed_with(WorldState& world, std::uint32_t body);

// What an end (0: a, 1: b) of a gear or a rack is measured against: the body to which the first
// joint among hinges and wheels, of a rack's b sliders, along the same axis holds it. None: the
// world.
std::uint32_t find_carrier(const WorldState& world, const Joint& gear, int end);

// Calls visit(JointedBodies) once for each that `bodies` are of, alone or with others.
template <class Bodies, class Visit>
void for_each_jointed(WorldState& world, const Bodies& bodies, Visit&& visit) {
    std::vector<std::uint8_t>& visited = world.scratch.visited_jointed;
    visited.assign(world.bodies.cold.size(), 0);
    for (const BodyWarm& warm : bodies) {
        if (visited[warm.body] != 0) continue;
        const JointedBodies jointed = jointed_with(world, warm.body);
        for (const std::uint32_t body : jointed.bodies) visited[body] = 1;
        visit(jointed);
    }
}

}  // namespace jostle::physics
