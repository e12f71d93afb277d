// SPDX-License-Identifier: MIT
#pragma once

#include "bench/integrators/particle_field.h"

namespace jostle::bench::integrators {

// A method that steps a particle through a field.
class Integrator {
public:
    virtual ~Integrator() = default;
    virtual void step(ParticleState& state, double t, double dt) = 0;  // from t to t + dt
};

}  // namespace jostle::bench::integrators
