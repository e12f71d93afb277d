// SPDX-License-Identifier: MIT
//
// What presses on chunks in a step, and what goes on pressing in the next.
#pragma once

#include <cstdint>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"
#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

// A contact of the last step upon a chunk.
struct ChunkContact {
    std::uint32_t destructible = 0, chunk = 0;
    physics::ShapeId own, other;
    physics::BodyId other_body;
    physics::Vec3 point, force;  // m; N, world
    bool impact = false;
    physics::Vec3 normal;                                         // unit, against the chunk
    double approach = 0, separation_speed = 0, inverse_mass = 0;  // m/s; 1/kg of both there
    double energy = 0;                                            // J
    bool mutual = false;           // bonds hold the other one, too: there is a press upon it
    double dissipated_energy = 0;  // J, for broken bonds
    double load_ratio = 0;         // what the worst bond had to bear, as a share of its strength
    bool is_duplicate = false;     // of two twins that both broke: the first one says it all
    bool grounded = false;         // something static presses on the piece, too
};
// What got its speed back and is still in touch: that is no new contact.
struct ReversedContact {
    std::uint32_t destructible = 0, chunk = 0;
    physics::ShapeId other;
    physics::BodyId other_body;
    physics::Vec3 point, normal;  // from the chunk
    double approach = 0;          // m/s
};

// A body of a whole, or near one, before the step.
struct PreStepState {
    physics::BodyState state;
    std::uint32_t destructible = 0;
};

}  // namespace jostle::modules::destruction_detail
