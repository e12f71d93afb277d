// SPDX-License-Identifier: MIT
//
// The five integrators of a group (E. Hairer, C. Lubich, G. Wanner, "Geometric numerical
// integration", chapter I; D. Baraff, A. Witkin, "Physically based modeling", SIGGRAPH 1997 course
// notes).
#pragma once

#include <vector>

#include "modules/particles/src/particle_forces.h"
#include "modules/particles/src/particle_scratch.h"

namespace jostle::modules::particles_detail {

// Advances positions and velocities by h seconds from `time`.
void integrate_particles(ParticleIntegrator integrator, const ParticleForces& forces,
                         std::vector<physics::Vec3>& positions,
                         std::vector<physics::Vec3>& velocities, double time, double h,
                         ParticleScratch& scratch);

// Solves v1 = v0 + h a(x0 + h v1, v1, time + h) for all particles by Newton's method.
void implicit_euler(const ParticleForces& forces, std::vector<physics::Vec3>& positions,
                    std::vector<physics::Vec3>& velocities, double time, double h,
                    ParticleScratch& scratch);

// Moves tracers with the medium: x' = u(x, t).
void integrate_tracers(ParticleIntegrator integrator, const ParticleForces& forces,
                       std::vector<physics::Vec3>& positions,
                       std::vector<physics::Vec3>& velocities, double time, double h);

}  // namespace jostle::modules::particles_detail
