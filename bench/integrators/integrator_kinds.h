// SPDX-License-Identifier: MIT
//
// The integrators: five textbook methods and Jostle's own.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/integrators/particle_field.h"

namespace jostle::bench::integrators {

// A method that steps a particle through a field.
class Integrator {
public:
    virtual ~Integrator() = default;
    virtual void step(ParticleState& state, double t, double dt) = 0;  // from t to t + dt
};

// Explicit, semi-implicit and implicit Euler, position Verlet, and the classical Runge-Kutta
// method, in a few lines each. The field must outlive the integrators.
std::unique_ptr<Integrator> make_explicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_implicit_euler(const ParticleField& field);
std::unique_ptr<Integrator> make_verlet(const ParticleField& field);
std::unique_ptr<Integrator> make_runge_kutta(const ParticleField& field);

// One free body in its own world. A step listener applies the field's force like any user code, at
// the midpoint position that each sub-step provides.
std::unique_ptr<Integrator> make_world_integrator(const ParticleField& field);

struct IntegratorKind {
    const char* name;
    const char* about;
    double order;  // of the global error in smooth fields
    std::unique_ptr<Integrator> (*make)(const ParticleField& field);
};

std::span<const IntegratorKind> integrator_kinds();
const IntegratorKind* find_integrator(std::string_view name);  // null: there is none

}  // namespace jostle::bench::integrators
