// SPDX-License-Identifier: MIT
//
// The joints of a body, and bodies connected by joints.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Adds a joint, whose record is complete, to the lists of its bodies and merges their islands (both
// awake).
void attach_joint(ContactGraph& stores, JointStore& joints, std::uint32_t joint);
// Destroys a joint. The shapes of its bodies may collide afterwards.
void destroy_joint(ShapedBodies& stores, JointStore& joints, std::uint32_t joint);
// Allows the direct solver again for the islands of a changed joint (Island::too_dense_for).
void reset_density(BodySets& sets, const JointStore& joints, std::uint32_t joint);
// Returns whether a joint prevents collisions between the two bodies.
bool joined_without_contact(const BodyStore& bodies, const JointStore& joints, std::uint32_t a,
                            std::uint32_t b);

// A body and all bodies connected to it by joints, sorted; `to_kinematic`: one of them is connected
// to a kinematic body, which they follow. Valid until the next call.
struct JointedBodies {
    std::span<const std::uint32_t> bodies;
    bool to_kinematic = false;
};
JointedBodies jointed_with(const BodyStore& bodies, const JointStore& joints, GraphScratch& scratch,
                           std::uint32_t body);

// Returns the carrier of an end (0: a, 1: b) of a gear or rack: the body to which the first hinge
// or wheel joint (for b of a rack, slider joint) along the same axis connects it. None: the world.
std::uint32_t find_carrier(const BodyStore& bodies, const JointStore& joints, const Joint& gear,
                           int end);

// Calls visit(JointedBodies) once for each group of bodies of the set that joints connect.
template <class Bodies, class Visit>
void for_each_jointed(const BodyStore& bodies, const JointStore& joints, GraphScratch& scratch,
                      const Bodies& set, Visit&& visit) {
    std::vector<std::uint8_t>& visited = scratch.visited_jointed;
    visited.assign(bodies.cold.size(), 0);
    for (const BodyWarm& warm : set) {
        if (visited[warm.body] != 0) continue;
        const JointedBodies jointed = jointed_with(bodies, joints, scratch, warm.body);
        for (const std::uint32_t body : jointed.bodies) visited[body] = 1;
        visit(jointed);
    }
}

}  // namespace jostle::physics
