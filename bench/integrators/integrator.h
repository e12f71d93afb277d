// SPDX-License-Identifier: MIT
//
// Ways to step a particle through a field: five of the textbooks, a few lines each, and Jostle's
// own.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "integrators/particle_field.h"

namespace jostle::bench::integrators {

class Integrator {
public:
    virtual ~Integrator() = default;
    virtual void step(ParticleState& state, double t, double dt) = 0;  // from t to t + dt
};

struct IntegratorKind {
    const char* name;
    const char* about;
    double order;  // of its global error in smooth fields
    std::unique_ptr<Integrator> (*make)(const ParticleField& field);
};

std::span<const IntegratorKind> integrator_kinds();
const IntegratorKind* find_integrator(std::string_view name);  // null: none

}  // namespace jostle::bench::integrators
