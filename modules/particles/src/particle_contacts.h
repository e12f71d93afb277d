// SPDX-License-Identifier: MIT
//
// Impacts between the particles of a group. Pairs are found with a grid, on all threads, and
// resolved one after the other in the order of their indices, so results do not depend on the
// number of threads. Each impact takes place at the moment at which the particles touched within
// the step, so an isolated pair moves as in continuous time. Particles have no spin, so there is no
// friction between them; linear and angular momentum are conserved. Planes, and the surfaces of
// bodies at rest that particles lie on, carry the particles above.
#pragma once

#include <vector>

#include "jostle/modules/particle_group.h"
#include "modules/particles/src/particle_scratch.h"

namespace jostle::modules::particles_detail {

// Two particles whose relative motion in a step exceeds this number of radii may pass each other.
inline constexpr double cell_radii = 4;
// Neighbours of a particle that are tested, and contacts of a particle with later ones.
inline constexpr std::uint32_t tests_max = 512, contacts_max = 16;
// Sweeps over all pairs after the first one; fewer if no particles approach each other.
inline constexpr int sweeps_max = 8;

// Resolves the impacts of the last h seconds, in which particles moved from `before`. Approach
// speeds up to `rest_speed` (m/s) do not rebound, so that particles come to rest on each other.
void resolve_contacts(const ParticleGroupDef& def, double h, double rest_speed,
                      const physics::World* world, const std::vector<physics::Vec3>& before,
                      std::vector<physics::Vec3>& positions, std::vector<physics::Vec3>& velocities,
                      ParticleScratch& scratch);

}  // namespace jostle::modules::particles_detail
