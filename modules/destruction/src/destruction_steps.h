// SPDX-License-Identifier: MIT
//
// The parts of a step of the destruction module, in order of their calls in Destruction. Functions
// on DestructionState; on the thread that steps the world.
#pragma once

#include <vector>

#include "jostle/physics/state_visitor.h"
#include "jostle/physics/world.h"
#include "modules/destruction/src/destruction_data.h"

namespace jostle::modules::destruction_detail {

// --- destruction_impact.cpp: before the step ---
// Stores the states of pieces and of the bodies that touch them, and updates the chunks that pass
// through their destructible.
void store_pre_step_states(DestructionState& state, const physics::World& world, double dt);
// Stores the states of bodies that start to touch a piece, and disables contacts of passing chunks.
void on_pre_solve(DestructionState& state, physics::PreSolve& pair);

// --- destruction_losses.cpp: bodies and shapes destroyed by others ---
void drop_lost_bodies(DestructionState& state, const physics::World& world);
void drop_lost_chunks(DestructionState& state, const physics::World& world,
                      Destructible& destructible, Piece& piece);

// --- destruction_loads.cpp: loads from contacts ---
void rebuild_derived_state(DestructionState& state);
void update_gravity(DestructionState& state, const physics::World& world);
void gather_contacts(DestructionState& state, const physics::World& world, double dt);
// Null: the shape has no bonds.
const BondedShape* find_bonded_shape(const DestructionState& state, physics::ShapeId shape);

// --- destruction_crack.cpp: breaking of bonds ---
void break_all_bonds(DestructionState& state, const physics::World& world);
std::vector<Group> connected_groups(const Destructible& destructible, const Group& group);
// Destruction::max_load_ratio().
double max_load_ratio(const physics::World& world, const Destructible& destructible);

// --- destruction_impact.cpp: reversal of excess impulses ---
void reverse_excess_impulses(DestructionState& state, physics::World& world, double dt);

// --- destruction_split.cpp: separation of pieces ---
void split_all_pieces(DestructionState& state, physics::World& world);
void start_passing(DestructionState& state);  // destruction_impact.cpp
void drop_debris(DestructionState& state, physics::World& world, double dt);

// --- destruction_state.cpp: saved state ---
void visit_state(physics::StateVisitor& v, DestructionState& state);

// Inverse effective mass of a body at a point along a unit direction, 1/kg; 0 if it cannot move.
inline double inverse_effective_mass(const physics::BodyState& body, physics::Vec3 point,
                                     physics::Vec3 n) {
    if (!(body.mass > 0)) return 0;
    const physics::Vec3 turn = cross(point - body.center, n);
    return 1 / body.mass + dot(turn, inverse(body.inertia) * turn);
}

inline physics::Vec3 velocity_at(const physics::BodyState& body, physics::Vec3 point) {
    return body.linear_velocity + cross(body.angular_velocity, point - body.center);
}

}  // namespace jostle::modules::destruction_detail
