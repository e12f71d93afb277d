// SPDX-License-Identifier: MIT
//
// The state of the destruction module: destructibles with their chunks, bonds and pieces, and the
// data of one step. Plain data; destruction_steps.h lists the functions on it.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "jostle/modules/destruction.h"
#include "modules/destruction/src/bond_network.h"

namespace jostle::modules::destruction_detail {

// Load on a chunk: acts at its centre of mass, in the frame of the destructible.
struct ChunkLoad {
    physics::Vec3 force, torque;  // N, N m
};

struct Chunk {
    physics::Vec3 center;  // in the frame of the destructible, as the following members
    double mass = 0;
    physics::Mat3 inertia;
    physics::ShapeId shape;
    bool anchored = false;
    physics::Vec3 force, torque;  // of contacts, when its bonds were last evaluated
    std::uint32_t piece = 0;      // derived
};
struct Bond {
    FractureBond face;
    bool broken = false;
};
// A connected group of chunks: one body, whose axes are those of the destructible.
struct Piece {
    physics::BodyId body;
    physics::Vec3 origin;  // of the body, in the frame of the destructible
    std::vector<std::uint32_t> chunks;
    bool anchored = false;
    bool solve_pending = true;   // must be evaluated, regardless of its loads
    bool solved = false;         // its factor was computed and counted as work
    bool loaded = false;         // by contacts, when last evaluated
    bool loads_pending = false;  // its chunks hold loads whose evaluation was deferred
    bool split_pending = false;  // bonds broke: it must be split
    double spin2 = 0;            // rad^2/s^2, squared angular speed when last evaluated
    double energy = 0;           // J, of the impacts whose loads are deferred
    double age = 0;              // s, of a loose single chunk
    double passing_time = 0;     // s, remaining time without collisions with its destructible

    physics::Vec3 linear, angular;  // m/s, rad/s: before the step

    // Derived: intact bonds inside the piece, and the factor of its stiffness matrix.
    std::vector<std::uint32_t> bonds;
    std::shared_ptr<const StiffnessFactor> factor;
};
struct Destructible {
    bool alive = false;
    std::uint32_t generation = 0;
    BondMaterial material;
    double density = 0;
    std::vector<Chunk> chunks;
    std::vector<Bond> bonds;
    std::vector<Piece> pieces;
};
struct BondedShape {  // a shape with bonds
    physics::ShapeId shape;
    std::uint32_t destructible = 0, chunk = 0;
};

// A contact of the last step on a chunk.
struct ChunkContact {
    std::uint32_t destructible = 0, chunk = 0;
    physics::ShapeId own, other;
    physics::BodyId other_body;
    physics::Vec3 point, force;  // m; N, world
    bool impact = false;
    physics::Vec3 normal;  // unit, pointing into the chunk
    // m/s; 1/kg, sum for both bodies at the point
    double approach = 0, separation_speed = 0, inverse_mass = 0;
    double energy = 0;             // J
    bool mutual = false;           // the other shape has bonds too, and a ChunkContact of its own
    double dissipated_energy = 0;  // J, dissipated by broken bonds
    double load_ratio = 0;         // largest load of a bond as a fraction of its strength
    bool is_duplicate = false;     // of a mutual pair in which both broke, the second entry
    bool grounded = false;         // a static body touches the piece as well
};
// A contact whose impulse was reversed and that is still touching. It causes no new begin event.
struct ReversedContact {
    std::uint32_t destructible = 0, chunk = 0;
    physics::ShapeId other;
    physics::BodyId other_body;
    physics::Vec3 point, normal;  // from the chunk
    double approach_speed = 0;    // m/s
};

// State before the step of a body of a destructible, or of one near it.
struct PreStepState {
    physics::BodyState state;
    std::uint32_t destructible = 0;
};

struct DestructionState {
    DestructionLimits limits;
    physics::Vec3 gravity;  // at the last evaluation of all pieces
    std::vector<Destructible> destructibles;
    std::vector<ReversedContact> reversed_contacts;

    // Derived, or valid for one step.
    bool derived = false;
    std::vector<BondedShape> bonded_shapes;  // sorted by shape
    std::vector<ChunkContact> chunk_contacts;
    std::vector<ChunkLoad> chunk_loads;  // by chunk; valid for one piece
    // Bodies, and indices of destructibles.
    std::vector<std::pair<physics::BodyId, std::uint32_t>> passing_bodies;
    // State before the step of bodies with reversed impulses.
    std::vector<physics::BodyState> reversed_bodies;
    // Pieces and bodies in contact with them, sorted by body.
    std::vector<PreStepState> pre_step_states;
    std::int64_t work_left = 0;
    double max_load_ratio = 0;  // of the last evaluated piece, before bonds broke
};

}  // namespace jostle::modules::destruction_detail
