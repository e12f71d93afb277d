// SPDX-License-Identifier: MIT
//
// Contact loads on chunks in a step, and contacts that continue in the next step.
#pragma once

#include <cstdint>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"
#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

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

}  // namespace jostle::modules::destruction_detail
