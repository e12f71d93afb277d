// SPDX-License-Identifier: MIT
//
// What pieces that break under a push give back to who pushed: impulses at the points where they
// met, for all that met in a step at once. Momenta stay what they were, and nobody has more energy
// afterwards than before.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

// A body after the step, and how it moved before.
struct ReversalBody {
    physics::BodyState state;
    physics::Vec3 linear, angular;   // m/s, rad/s, before
    physics::Vec3 gravity_velocity;  // m/s, that gravity gives in a step

    double energy() const;  // J, now
    // Before, with the work that gravity did on its way since then: none on what rests.
    double energy_before() const;
};

struct ImpulseReversal {
    physics::Vec3 point, normal;        // the normal pushes what struck on its way
    std::size_t piece = 0, struck = 0;  // of the bodies that met
    double speed = 0;                   // m/s, against each other, that it shall have
    double inverse_mass_piece = 0,
           inverse_mass_struck = 0;  // 1/kg; 0 of a piece: the ground takes what it gives
    double dissipated_energy = 0;    // J, for broken bonds
    double impulse = 0;              // N s, that is given back in the end
};

// Fills in the impulses, and changes how the bodies move by them. What hangs together by impulses
// or by `links`, two bodies each, has in the end no more energy than before the step, less what was
// paid; or than after it, where something else gave it more.
void reverse_impulses(std::span<ReversalBody> bodies, std::span<ImpulseReversal> all,
                      std::span<const std::pair<std::size_t, std::size_t>> pairs);

}  // namespace jostle::modules::destruction_detail
