// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "bench/integrators/integrator.h"

namespace jostle::bench::integrators {

// One free body in a world of its own. A listener pushes it with the field's force, as any user's
// would, where the step shows it the body: in the middle of the step.
std::unique_ptr<Integrator> make_world_integrator(const ParticleField& field);

}  // namespace jostle::bench::integrators
