// SPDX-License-Identifier: MIT
//
// The Engine adapter for the Open Dynamics Engine. Built only if the library is installed.
#pragma once

#include <memory>

#include "bench/speed/engine.h"

namespace jostle::bench {

std::unique_ptr<Engine> make_ode_engine();

}  // namespace jostle::bench
