// SPDX-License-Identifier: MIT
//
// ODE adapter of the accuracy benchmark.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_ode_accuracy_engine();

}  // namespace jostle::bench::accuracy
