// SPDX-License-Identifier: MIT
//
// The edges between stores: contact to body, body to island, body to set. Every change of an edge
// goes through here, so that the stores agree; state/validate.h checks that they do.
#pragma once

#include "state/world_state.h"

namespace jostle::physics {

// --- contacts ---
// A new contact on the waiting list, to be checked in the next step. Orders the shapes so that a is
// dynamic.
std::uint32_t create_contact(WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b);
// A manifold of a composite pair; it has no lane yet.
std::uint32_t create_part(WorldState& world, std::uint32_t parent, std::uint64_t key);
// Destroys its parts, frees its lane, unbinds the islands, reports the end when it was touching (to
// `ended`).
void destroy_contact(WorldState& world, std::uint32_t contact, std::vector<ContactEnd>& ended);
void destroy_contacts_of(WorldState& world, std::uint32_t body, std::vector<ContactEnd>& ended);
void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape,
                               std::vector<ContactEnd>& ended);
// All contacts between two bodies.
void destroy_contacts_between(WorldState& world, std::uint32_t body, std::uint32_t other,
                              std::vector<ContactEnd>& ended);
void report_end(const WorldState& world, const Contact& contact, std::vector<ContactEnd>& ended);
// Reports the end of a composite pair none of whose parts touches any more.
void settle_pair(WorldState& world, std::uint32_t pair);
// What is held back of a slack, m: within a kilometre the floats of SeparationBound::apart are off
// by less.
inline constexpr double slack_reserve = 1e-4;
// From now on by the motion of the two centres, which are `apart`, against each other: along a
// direction, or by its length if that is zero. `a`, `b`: of the two bodies.
void set_separation_bound(SeparationBound& waiting, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b);
void add_separation_bound(WorldState& world, std::uint32_t contact, double slack,
                          Vec3 direction = {});
// A dormant contact waits again, as before.
void resume_separation_bound(WorldState& world, std::uint32_t contact);

// --- joints ---
// The joint's record is filled: puts it on its bodies' lists and joins their islands (both awake).
void link_joint(WorldState& world, std::uint32_t joint);
void destroy_joint(WorldState& world, std::uint32_t joint);
// Whether a joint forbids the two bodies to collide.
bool joined_without_contact(const WorldState& world, std::uint32_t a, std::uint32_t b);

// --- islands ---
std::uint32_t create_island(WorldState& world);
void add_to_island(WorldState& world, std::uint32_t island, std::uint32_t body);
// Frees the island when its last body leaves.
void remove_from_island(WorldState& world, std::uint32_t body);
// The smaller joins the larger; of equals the higher index joins the lower. Both awake.
void join_islands(WorldState& world, std::uint32_t a, std::uint32_t b);
// Begins or ends the bond that a touching contact is.
void begin_touch(WorldState& world, std::uint32_t contact);
void end_touch(WorldState& world, std::uint32_t contact);

// --- sets ---
// Moves the warm record into a set. `warm` is taken as it is.
void enter_fixed(WorldState& world, const BodyWarm& warm);
void enter_awake(WorldState& world, const BodyWarm& warm);
// The last body of the set moves into the hole.
void leave_set(WorldState& world, std::uint32_t body);

// If there are enough of them, bodies wake frozen, with what presses on them: who disturbs the
// island thaws what that stirs. Not what joints tie to a kinematic body.
void wake_island(WorldState& world, std::uint32_t island, std::vector<BodyId>& woke);
void put_island_to_sleep(WorldState& world, std::uint32_t island);
// Wakes a dynamic body's island if it sleeps, and starts its rest time anew.
void wake_body(WorldState& world, std::uint32_t body);
// Wakes everything that touches the body or is near it.
void wake_neighbours(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
