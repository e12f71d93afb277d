// SPDX-License-Identifier: MIT
//
// Explicit, semi-implicit and implicit Euler, position Verlet, and the classical Runge-Kutta
// method, in a few lines each. The field must outlive the integrators.
#pragma once

#include <memory>

#include "bench/integrators/integrator.h"

namespace jostle::bench::integrators {

std::unique_ptr<Integrator> make_explicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_implicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_verlet(const ParticleField& field);
std::unique_ptr<Integrator> make_runge_kutta(const ParticleField& field);

}  // namespace jostle::bench::integrators
