// SPDX-License-Identifier: MIT
//
// ODE as a peer of the laboratory.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_ode_accuracy_engine();

}  // namespace jostle::bench::accuracy
