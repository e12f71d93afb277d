// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "bench/integrators/integrator.h"

namespace jostle::bench::integrators {

// One free body in its own world. A step listener applies the field's force like any user code, at
// the midpoint position that each sub-step provides.
std::unique_ptr<Integrator> make_world_integrator(const ParticleField& field);

}  // namespace jostle::bench::integrators
