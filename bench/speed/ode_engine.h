// SPDX-License-Identifier: MIT
//
// The Open Dynamics Engine behind the Engine interface. Only in builds that found its library.
#pragma once

#include <memory>

#include "bench/speed/engine.h"

namespace jostle::bench {

std::unique_ptr<Engine> make_ode_engine();

}  // namespace jostle::bench
