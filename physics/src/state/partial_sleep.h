// SPDX-License-Identifier: MIT
//
// Bodies that rest in an island that moves elsewhere. A frozen body stays in the awake set, but
// nobody solves it: for its neighbours that move it is as good as fixed, and manifolds between
// frozen bodies lie in a store of their own. What would move it thaws it
// (stages/sleep/update_partial_sleep.h). Bodies that joints tie together are frozen and thaw as
// one, so no joint has one that moves and one that does not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/tuning.h"
#include "state/world_state.h"

namespace jostle::physics {

// The force of a contact's lane, N, on body b.
Vec3 load_of(WorldState& world, const Contact& contact);

// When one of its bodies was frozen.
Vec3 load_before(const Contact& contact);
// What that was the weight of, kg; 0 without gravity.
double mass_borne_by(const WorldState& world, const Contact& contact);

// The body and all that joints tie to it, in order; `to_driver`: one of them is tied to a kinematic
// body, which they follow. Until the next call.
struct JointedBodies {
    std::span<const std::uint32_t> bodies;
    bool to_driver = false;
};
JointedBodies jointed_with(WorldState& world, std::uint32_t body);

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

// Freezes dynamic bodies of the awake set, all of those that are jointed together and to no
// driver, and keeps the forces at their contacts.
void sleep_in_place(WorldState& world, std::span<const std::uint32_t> bodies);

// The two halves of that, for a caller who moves the manifolds himself: all bodies first.
void hold_still(WorldState& world, std::uint32_t body);
void keep_load(WorldState& world, std::uint32_t contact);

// The body moves again, it alone. Its rest time goes on.
void wake_in_place(WorldState& world, std::uint32_t body);
// With all that is jointed to it, and rest times begin anew.
void wake_from_partial_sleep(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

// ... and go on, but for the last steps before it would freeze: what still rests
// soon freezes again, with what presses on it now.
void wake_briefly(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

// Thaws the body, and briefly so much of what manifolds lead to from it, kg: an impact is felt by
// more than the body that it hits, and what lost its support may have borne more than itself.
void wake_around(WorldState& world, std::uint32_t body, double mass, std::vector<BodyId>& woke);

// What would follow if it came to rest in so much at once would be slow.
inline double mass_stirred_by(double momentum) {
    return momentum / tuning::gentle_speed;
}

// Makes sure that a dynamic body moves: wakes its island or thaws it.
void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

}  // namespace jostle::physics
