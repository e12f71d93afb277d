// SPDX-License-Identifier: MIT
//
// Reverses the excess impulses of impacts on breaking pieces: impulses at the contact points of all
// impacts of a step, solved at once. They conserve momentum and never increase the energy of the
// bodies involved.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

// Pairs of indices of bodies.
using BodyPairs = std::vector<std::pair<std::size_t, std::size_t>>;

// A body after the step, and its velocity before.
struct ReversalBody {
    physics::BodyState state;
    physics::Vec3 linear, angular;   // m/s, rad/s, before the step
    physics::Vec3 gravity_velocity;  // m/s, velocity change by gravity in a step

    double energy() const;  // J, current
    // Energy before the step plus the work of gravity during the step; bodies at rest have none.
    double energy_before() const;
};

struct ImpulseReversal {
    physics::Vec3 point, normal;        // the normal pushes the striking body back
    std::size_t piece = 0, struck = 0;  // indices of the bodies in contact
    double speed = 0;                   // m/s, approach speed to restore
    // 1/kg; a piece with 0 does not move: the ground takes the reaction
    double inverse_mass_piece = 0, inverse_mass_struck = 0;
    double dissipated_energy = 0;  // J, dissipated by broken bonds
    double impulse = 0;            // N s, resulting impulse
};

// Computes the impulses and applies them to the bodies. Bodies connected by impulses or by `pairs`
// form a group. The energy of a group does not exceed its energy before the step minus the
// dissipated energy, or its energy after the step if other causes increased it beyond that.
void reverse_impulses(std::span<ReversalBody> bodies, std::span<ImpulseReversal> all,
                      std::span<const std::pair<std::size_t, std::size_t>> pairs);

}  // namespace jostle::modules::destruction_detail
